//! Enums whose variants have texts, each written as a table.

/// Defines an enum as a table: each variant with the texts that have been written for it, and a function for
/// each column. The number of columns stands behind the enum's name.
///
/// ```
/// pinhole_core::texts! {
///     /// A way to go.
///     #[derive(Clone, Copy)]
///     pub enum Way[2];
///     {
///         /// Returns the label.
///         label,
///         /// Returns the name in files.
///         name,
///     }
///     /// To the left.
///     Left: "To the left", "left";
///     /// To the right.
///     Right: "To the right", "right";
/// }
///
/// assert_eq!(Way::ALL.map(Way::name), ["left", "right"]);
/// ```
#[macro_export]
macro_rules! texts {
    (@columns $index:expr;) => {};
    (@columns $index:expr; $(#[$doc:meta])* $column:ident, $($rest:tt)*) => {
        $(#[$doc])*
        pub fn $column(self) -> &'static str {
            self.texts()[$index]
        }

        $crate::texts!(@columns $index + 1; $($rest)*);
    };
    (
        $(#[$meta:meta])* $visibility:vis enum $name:ident[$count:literal];
        { $($columns:tt)* }
        $($(#[$doc:meta])* $variant:ident: $($text:expr),+;)*
    ) => {
        $(#[$meta])*
        $visibility enum $name {
            $($(#[$doc])* $variant,)*
        }

        impl $name {
            /// All of them, in order.
            pub const ALL: [$name; [$($name::$variant),*].len()] = [$($name::$variant),*];

            fn texts(self) -> [&'static str; $count] {
                match self {
                    $($name::$variant => [$($text),+],)*
                }
            }

            $crate::texts!(@columns 0; $($columns)*);
        }
    };
}
