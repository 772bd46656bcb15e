//! A screen reader: it hears what the window says of itself, by the desktop's own protocol (AT-SPI
//! over D-Bus), in another process than the program.

use std::fmt::{self, Debug, Formatter};

use egui::{Rect, pos2, vec2};
use pollster::block_on;
use serde::de::DeserializeOwned;
use zbus::Connection;
use zbus::connection::Builder;
use zbus::zvariant::{DynamicType, OwnedObjectPath, OwnedValue, Type, Value};

use crate::bus::Bus;

/// Kinds of what is in the window, by their numbers in AT-SPI.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Role(u32);

pub(crate) const IMAGE: Role = Role(27);
pub(crate) const LABEL: Role = Role(29);
pub(crate) const BUTTON: Role = Role(43);
pub(crate) const NUMBER: Role = Role(52);
/// A button that stays pressed, as a tab does.
pub(crate) const TOGGLE: Role = Role(62);

/// Coordinates from the window's top left corner, by their number in AT-SPI.
const OF_WINDOW: u32 = 1;

/// The bit of the first 32 states that says that keys go there.
const FOCUSED: u32 = 1 << 12;

/// A name on the bus and an object there.
type Address = (String, OwnedObjectPath);

/// What the list of all nodes says of each: object, application, parent, index, number of children,
/// interfaces, name, role, description, states.
type Listed = (Address, Address, Address, i32, i32, Vec<String>, String, u32, String, Vec<u32>);

/// Something in the window, as it is told.
pub(crate) struct Node {
    pub(crate) role: Role,
    pub(crate) name: String,
    pub(crate) description: String,
    pub(crate) has_focus: bool,
    address: Address,
}

impl Debug for Node {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        write!(f, "{} {:?}: {:?}", self.role.0, self.name, self.description)
    }
}

/// The screen reader.
pub(crate) struct Reader {
    bus: Connection,
}

impl Reader {
    /// Switches accessibility on, for all programs on the bus.
    pub(crate) fn start(bus: &Bus) -> Reader {
        block_on(async {
            let session = Builder::address(bus.address.as_str())?.build().await?;
            let service = ("org.a11y.Bus".to_owned(), path("/org/a11y/bus"));
            let on = ("org.a11y.Status", "IsEnabled", Value::from(true));
            call::<()>(&session, &service, "org.freedesktop.DBus.Properties", "Set", &on).await?;
            let address: String =
                call(&session, &service, "org.a11y.Bus", "GetAddress", &()).await?;
            let bus = Builder::address(address.as_str())?.build().await?;
            zbus::Result::Ok(Reader { bus })
        })
        .expect("at-spi2-core is installed: .ci/run does it")
    }

    /// Everything that the only program tells; nothing before it has begun to, or if it changes
    /// meanwhile.
    pub(crate) fn nodes(&self) -> Option<Vec<Node>> {
        block_on(async {
            let registry =
                ("org.a11y.atspi.Registry".to_owned(), path("/org/a11y/atspi/accessible/root"));
            let accessible = "org.a11y.atspi.Accessible";
            let programs: Vec<Address> =
                call(&self.bus, &registry, accessible, "GetChildren", &()).await.ok()?;
            let [(program, _)] = programs.as_slice() else { return None };
            let cache = (program.clone(), path("/org/a11y/atspi/cache"));
            let listed: Vec<Listed> =
                call(&self.bus, &cache, "org.a11y.atspi.Cache", "GetItems", &()).await.ok()?;
            let nodes = listed.into_iter().map(|listed| {
                let (address, _, _, _, _, _, name, role, description, states) = listed;
                let has_focus = states[0] & FOCUSED != 0;
                Node { role: Role(role), name, description, has_focus, address }
            });
            Some(nodes.collect())
        })
    }

    /// Where it is in the window, in dots.
    pub(crate) fn rect(&self, node: &Node) -> Option<Rect> {
        let component = "org.a11y.atspi.Component";
        let extents = call(&self.bus, &node.address, component, "GetExtents", &OF_WINDOW);
        let (x, y, width, height): (i32, i32, i32, i32) = block_on(extents).ok()?;
        let [x, y, width, height] = [x, y, width, height].map(|dots| dots as f32);
        Some(Rect::from_min_size(pos2(x, y), vec2(width, height)))
    }

    /// Presses it, where there is neither a mouse nor a key.
    pub(crate) fn press(&self, node: &Node) -> Option<()> {
        let press = call(&self.bus, &node.address, "org.a11y.atspi.Action", "DoAction", &0_i32);
        block_on(press).ok().filter(|was_done| *was_done).map(|_: bool| ())
    }

    /// The number that it stands at.
    pub(crate) fn number(&self, node: &Node) -> Option<f64> {
        let properties = "org.freedesktop.DBus.Properties";
        let which = ("org.a11y.atspi.Value", "CurrentValue");
        let value: OwnedValue =
            block_on(call(&self.bus, &node.address, properties, "Get", &which)).ok()?;
        value.try_into().ok()
    }
}

fn path(path: &'static str) -> OwnedObjectPath {
    path.try_into().unwrap()
}

async fn call<T: DeserializeOwned + Type>(
    bus: &Connection,
    (service, object): &Address,
    interface: &str,
    method: &str,
    with: &(impl serde::Serialize + DynamicType),
) -> zbus::Result<T> {
    let answer =
        bus.call_method(Some(service.as_str()), object, Some(interface), method, with).await?;
    answer.body().deserialize()
}
