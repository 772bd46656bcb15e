//! Enums as tables: each variant stands with its texts, once.

/// Defines an enum without data, its `ALL`, the variants in their order, and its `texts`, the texts
/// behind each variant.
macro_rules! named_enum {
    (
        $(#[$about:meta])*
        pub enum $name:ident { $($(#[$doc:meta])* $variant:ident: $($text:expr),+;)+ }
    ) => {
        $(#[$about])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        pub enum $name {
            $($(#[$doc])* $variant),+
        }

        impl $name {
            /// All of them, in order.
            pub const ALL: [$name; [$($name::$variant),+].len()] = [$($name::$variant),+];

            fn texts(self) -> &'static [&'static str] {
                match self {
                    $($name::$variant => &[$($text),+]),+
                }
            }
        }
    };
}

pub(crate) use named_enum;
