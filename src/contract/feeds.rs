//! Attributes that the geometries of libraries feed.

use crate::bindings::ProgramBindings;
use crate::breach::{Breach, nearest};
use crate::interface::DeclaredInput;
use crate::library::{GeometryKind, LibraryExport, attributes_of_shapes, geometry_kind};
use crate::materials::Material;
use crate::shape::ValueShape;
use shaderlint_script::{
    EventKind, ForeignCall, ObjectId, ObjectKind, ScriptPlace, ScriptValue, World,
};
use shaderlint_semantic::Scalar;

/// The data of an attribute.
struct Feed {
    name: String,
    place: ScriptPlace,
    /// Numbers per vertex.
    size: Option<f64>,
    /// How many numbers there are.
    length: Option<usize>,
    /// Name of the class of its data.
    class: String,
}

/// What a geometry feeds.
#[derive(Default)]
struct Geometry {
    feeds: Vec<Feed>,
    /// Whether it may feed others.
    is_open: bool,
    place: ScriptPlace,
}

/// Adds what is wrong with the attributes of programs of libraries, and the places that name them.
pub fn check(
    world: &World,
    materials: &[Material],
    found: &mut Vec<Breach>,
    bindings: &mut [ProgramBindings],
) {
    for (material, bindings) in materials.iter().zip(bindings) {
        let mut all = geometries(world, material);
        // With several, each must feed the shader; one that is not known may be the one in use.
        if let Some(object) = material.attributes.as_ref().and_then(ScriptValue::object) {
            all.push(of_object(world, object));
        }
        for geometry in all {
            check_geometry(world, material, &geometry, found);
            // A shape of a library names its attributes itself.
            for feed in &geometry.feeds {
                if let Some(place) = world.named(feed.place, &feed.name) {
                    bindings.mentions.push((feed.name.clone(), place));
                }
            }
        }
    }
}

fn check_geometry(
    world: &World,
    material: &Material,
    geometry: &Geometry,
    found: &mut Vec<Breach>,
) {
    let Some(vertex) = &material.stages.vertex else {
        return;
    };
    let active = || vertex.inputs.iter().filter(|a| a.is_active);
    found.extend(uneven(geometry));
    for attribute in active() {
        let feed = geometry
            .feeds
            .iter()
            .find(|feed| feed.name == attribute.name);
        match feed {
            Some(feed) => found.extend(wrong_data(attribute, feed)),
            None if geometry.is_open => {}
            None => {
                let strays = geometry
                    .feeds
                    .iter()
                    .filter(|feed| !vertex.mentions(&feed.name));
                let strays: Vec<&Feed> = strays.collect();
                let near = nearest(
                    &attribute.name,
                    strays.iter().map(|feed| feed.name.as_str()),
                );
                let near = near.and_then(|near| strays.iter().find(|feed| feed.name == near));
                let is_given = material.maker.feeds(&attribute.name) && near.is_none();
                if is_given || near.is_none() && world.is_mentioned(&attribute.name) {
                    continue;
                }
                let place =
                    near.map_or(attribute.place.unwrap_or(geometry.place), |feed| feed.place);
                let message = format!("attribute `{}` gets no data", attribute.name);
                let other = match near {
                    Some(_) => attribute.place,
                    None => Some(geometry.place),
                };
                let label = if near.is_some() {
                    "declared here"
                } else {
                    "this geometry has none of this name"
                };
                let breach = Breach::new("attribute-data", place, message)
                    .label(other, label)
                    .note("without data it is (0, 0, 0, 1) for all vertices")
                    .help(near.map(|feed| format!("`{}` has a similar name", feed.name)));
                found.push(breach);
            }
        }
    }
}

/// The number of numbers in data.
fn count(world: &World, data: &ScriptValue) -> Option<usize> {
    match ValueShape::of(world, data) {
        ValueShape::Numbers(count) => count,
        _ => None,
    }
}

/// An attribute with data for fewer vertices than another.
fn uneven(geometry: &Geometry) -> Option<Breach> {
    let vertices = |feed: &Feed| Some(feed.length? as f64 / feed.size?);
    let counts = geometry
        .feeds
        .iter()
        .filter_map(|feed| Some((feed, vertices(feed)?)));
    let most = counts.clone().map(|(_, count)| count).fold(0.0, f64::max);
    let (feed, count) = counts.min_by(|a, b| a.1.total_cmp(&b.1))?;
    (count < most).then(|| {
        let message = format!(
            "attribute `{}` has data for {count} vertices, another for {most}",
            feed.name
        );
        Breach::new("attribute-data", feed.place, message).note(format!(
            "{} numbers, {} per vertex",
            feed.length.unwrap_or(0),
            feed.size.unwrap_or(0.0)
        ))
    })
}

/// Data of the wrong size or type for an attribute.
fn wrong_data(attribute: &DeclaredInput, feed: &Feed) -> Option<Breach> {
    let components = f64::from(attribute.components()?);
    let breach = |message: String| {
        Breach::new("attribute-data", feed.place, message).label(
            attribute.place,
            format!("declared as `{}`", attribute.type_name),
        )
    };
    let (name, type_name) = (&attribute.name, &attribute.type_name);
    let is_integer = matches!(attribute.scalar()?, Scalar::Int | Scalar::Uint);
    if is_integer && feed.class.starts_with("Float") {
        let message = format!(
            "attribute `{name}` is a `{type_name}`, but its data is a `{}`",
            feed.class
        );
        return Some(
            breach(message).note("drawing reports INVALID_OPERATION, and nothing is drawn"),
        );
    }
    let size = feed.size?;
    // The missing fourth component is 1, as of a position.
    let is_usual = components == 4.0 && size == 3.0;
    if size < components && !is_usual {
        let message = format!(
            "attribute `{name}` is a `{type_name}`, but its data has {size} numbers per vertex"
        );
        return Some(breach(message).note("the missing components are 0"));
    }
    None
}

/// The geometries that are drawn with a material.
fn geometries(world: &World, material: &Material) -> Vec<Geometry> {
    let mut found = Vec::new();
    for event in &world.events {
        let EventKind::Call(call) = &event.kind else {
            continue;
        };
        if !call.is_new {
            continue;
        }
        if call.callee.is_none() {
            found.extend(of_element(world, call, material));
            continue;
        }
        let is_it = |value: &ScriptValue| value.object() == Some(material.call.result);
        let holder = call.arguments.iter().rev().find(|(value, _)| {
            is_it(value)
                || ["material", "program", "shader"]
                    .iter()
                    .any(|key| world.get(value, key).is_some_and(is_it))
        });
        let Some((holder, _)) = holder else { continue };
        let geometry = match is_it(holder) {
            true => call.arguments.first().map(|(value, _)| value.clone()),
            false => world.get(holder, "geometry").cloned(),
        };
        let Some(id) = geometry.and_then(|value| value.object()) else {
            continue;
        };
        found.extend(of_geometry(world, id));
    }
    found
}

/// What an object of a class for geometries feeds.
fn of_geometry(world: &World, id: ObjectId) -> Option<Geometry> {
    let mut id = id;
    let mut call = world.call_of(id)?;
    // `new Geometry().addAttribute(...)`
    while !call.is_new
        && ["addAttribute", "setAttribute", "addIndex", "setIndex"].contains(&&*call.name)
    {
        id = call.this?;
        call = world.call_of(id)?;
    }
    let origin = LibraryExport::of(world, call.callee)?;
    let mut geometry = Geometry {
        place: world.object(id)?.place,
        ..Geometry::default()
    };
    let object =
        call.arguments
            .iter()
            .find_map(|(value, _)| match world.get(value, "attributes") {
                Some(attributes) => attributes.object(),
                None => value.object().filter(|id| {
                    world
                        .object(*id)
                        .is_some_and(|o| matches!(o.kind, ObjectKind::Plain))
                }),
            });
    match (geometry_kind(&origin), object) {
        (Some(GeometryKind::Empty), _) | (Some(GeometryKind::Object), None) => {}
        (Some(GeometryKind::Object), Some(object)) => geometry = of_object(world, object),
        (Some(GeometryKind::Shape), _) => {
            let shape = attributes_of_shapes().iter().map(|name| Feed {
                name: name.clone(),
                place: geometry.place,
                size: None,
                length: None,
                class: String::new(),
            });
            geometry.feeds.extend(shape);
        }
        (Some(GeometryKind::Open) | None, _) => geometry.is_open = true,
    }
    add_set(world, id, &mut geometry);
    Some(geometry)
}

/// Adds the attributes that methods set: `geometry.setAttribute(name, attribute)`.
fn add_set(world: &World, id: ObjectId, geometry: &mut Geometry) {
    // Methods that return the geometry may follow each other.
    let mut owners = vec![id];
    for event in &world.events {
        let EventKind::Call(call) = &event.kind else {
            continue;
        };
        let is_own = call.this.is_some_and(|this| owners.contains(&this));
        if !is_own {
            // A function that is not known may add some.
            let gets = |(value, _): &(ScriptValue, ScriptPlace)| value.object() == Some(id);
            let is_library = LibraryExport::of(world, call.callee).is_some() || call.this.is_some();
            geometry.is_open |= call.arguments.iter().any(gets) && !is_library;
            continue;
        }
        match &*call.name {
            "setAttribute" | "addAttribute" => {
                let Some(name) = call.arguments.first().and_then(|(value, _)| value.text()) else {
                    geometry.is_open = true;
                    continue;
                };
                let place = call
                    .arguments
                    .first()
                    .map_or(event.place, |(_, place)| *place);
                let data = call.arguments.get(1).map(|(value, _)| value);
                let size = call.arguments.get(2).and_then(|(value, _)| value.number());
                geometry.feeds.push(feed(world, name, data, size, place));
                owners.push(call.result);
            }
            "setIndex"
            | "computeVertexNormals"
            | "setDrawRange"
            | "translate"
            | "rotateX"
            | "scale"
            | "dispose"
            | "computeBoundingSphere"
            | "computeBoundingBox"
            | "center"
            | "addIndex"
            | "deleteAttribute" => {
                owners.push(call.result);
                if &*call.name == "computeVertexNormals" {
                    geometry
                        .feeds
                        .push(feed(world, "normal", None, None, event.place));
                }
            }
            "getAttribute" | "addGroup" | "clearGroups" => {}
            _ => geometry.is_open = true,
        }
    }
}

/// An attribute with its data.
fn feed(
    world: &World,
    name: &str,
    data: Option<&ScriptValue>,
    size: Option<f64>,
    place: ScriptPlace,
) -> Feed {
    let call = data
        .and_then(ScriptValue::object)
        .and_then(|id| world.call_of(id));
    let mut found = Feed {
        name: name.to_string(),
        place,
        size,
        length: data.and_then(|value| count(world, value)),
        class: String::new(),
    };
    let Some(call) = call else {
        return found;
    };
    let is_attribute = call.name.ends_with("BufferAttribute");
    if is_attribute {
        found.size = call.arguments.get(1).and_then(|(value, _)| value.number());
        let array = call
            .arguments
            .first()
            .and_then(|(value, _)| world.call_of(value.object()?));
        found.class = match call.name.strip_suffix("BufferAttribute") {
            Some("" | "Instanced") | None => {
                array.map_or(String::new(), |array| array.name.to_string())
            }
            Some(class) => format!("{class}Array"),
        };
    }
    found
}

/// The attributes in an object: `{ name: { size, data } }`, `{ name: data }`.
fn of_object(world: &World, id: ObjectId) -> Geometry {
    let Some(object) = world.object(id) else {
        return Geometry {
            is_open: true,
            ..Geometry::default()
        };
    };
    let mut geometry = Geometry {
        is_open: object.is_open || !matches!(object.kind, ObjectKind::Plain),
        place: object.place,
        ..Geometry::default()
    };
    for property in object
        .properties
        .iter()
        .filter(|p| &*p.key != "index" && &*p.key != "elements")
    {
        let size = world
            .get(&property.value, "size")
            .and_then(ScriptValue::number);
        let nested = match ValueShape::of(world, &property.value) {
            ValueShape::List(_, of) => match *of {
                ValueShape::Numbers(Some(count)) => Some(count as f64),
                _ => None,
            },
            _ => None,
        };
        geometry.feeds.push(Feed {
            name: property.key.to_string(),
            place: property.place,
            size: size.or(nested),
            length: count(
                world,
                world
                    .get(&property.value, "data")
                    .unwrap_or(&property.value),
            ),
            class: String::new(),
        });
    }
    geometry
}

/// The geometry beside a material in an element: `<mesh><bufferGeometry /><shaderMaterial /></mesh>`.
fn of_element(world: &World, call: &ForeignCall, material: &Material) -> Option<Geometry> {
    let children = call.arguments.get(1).map(|(value, _)| value)?;
    let children = world.elements(children)?;
    children
        .iter()
        .find(|child| child.object() == Some(material.call.result))?;
    let geometry = children.iter().find_map(|child| {
        let id = child.object()?;
        let own = world.call_of(id)?;
        own.name.ends_with("eometry").then_some((id, own))
    });
    let (id, own) = geometry?;
    let mut found = Geometry {
        place: world.object(id)?.place,
        is_open: &*own.name != "bufferGeometry",
        ..Geometry::default()
    };
    let inner = own
        .arguments
        .get(1)
        .and_then(|(value, _)| world.elements(value));
    for child in inner.unwrap_or(&[]) {
        let element = child.object().and_then(|id| world.call_of(id));
        let Some(element) = element.filter(|e| e.name.ends_with("ufferAttribute")) else {
            found.is_open = true;
            continue;
        };
        let attributes = element.arguments.first().map(|(value, _)| value)?;
        let attach = world.get(attributes, "attach").and_then(ScriptValue::text);
        let name = attach.and_then(|a| {
            a.strip_prefix("attributes-")
                .or(a.strip_prefix("attributes."))
        });
        let Some(name) = name else {
            found.is_open = true;
            continue;
        };
        let arguments = world
            .get(attributes, "args")
            .and_then(|value| world.elements(value));
        let size = arguments
            .and_then(|a| a.get(1))
            .or(world.get(attributes, "itemSize"));
        let place = world
            .property(attributes.object()?, "attach")
            .map(|p| p.place);
        found.feeds.push(Feed {
            name: name.to_string(),
            place: place.unwrap_or(found.place),
            size: size.and_then(ScriptValue::number),
            length: None,
            class: String::new(),
        });
    }
    // `ref` lets the program set others.
    let attributes = own
        .arguments
        .first()
        .and_then(|(value, _)| world.object(value.object()?));
    found.is_open |= attributes.is_some_and(|o| !o.properties.is_empty() || o.is_open);
    Some(found)
}
