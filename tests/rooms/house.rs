//! The imports and method calls between the files of `src`, and which of them the order of the rooms forbids.
//!
//! In: the modules with their texts, and the rooms, lowest first. Out: upward imports and circles.

use std::collections::{BTreeMap, BTreeSet};

use super::circle::leading_into_circles;
use super::paths::{Method, Named};

/// A module as its path of names; the root of the crate has none.
pub type Module = Vec<String>;

/// An import from a higher room.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Upward {
    /// The importing module, `/`-separated.
    pub from: String,
    /// The higher room.
    pub room: String,
}

/// All modules, the paths that they use, and their rooms.
pub struct House {
    named: BTreeMap<Module, Named>,
    /// Lowest first. A room is a module with its descendants, except those that are separate rooms.
    rooms: Vec<String>,
}

impl House {
    /// Builds a house from modules with their texts. Test modules are left out.
    pub fn new(sources: &BTreeMap<Module, String>, rooms: &[&str]) -> Self {
        let mut named: BTreeMap<Module, Named> =
            sources.iter().map(|(module, text)| (module.clone(), Named::read(text))).collect();
        let below = |module: &Module, name: &String| [module.as_slice(), std::slice::from_ref(name)].concat();
        let for_tests: Vec<Module> = named
            .iter()
            .flat_map(|(module, named)| named.test_modules.iter().map(|name| below(module, name)))
            .collect();
        named.retain(|module, _| !for_tests.iter().any(|test| module.starts_with(test)));
        Self { named, rooms: rooms.iter().map(|room| (*room).to_owned()).collect() }
    }

    /// The position of the room of a module in the order; `None` for the root of the crate.
    fn room(&self, module: &Module) -> Option<usize> {
        let name = module.join("/");
        let is_in =
            |room: &str| name.strip_prefix(room).is_some_and(|rest| rest.is_empty() || rest.starts_with('/'));
        let rooms = self.rooms.iter().enumerate().filter(|(_, room)| is_in(room));
        rooms.max_by_key(|(_, room)| room.len()).map(|(place, _)| place)
    }

    /// Modules without a room, and rooms without a module.
    pub fn unlisted(&self) -> Vec<String> {
        let modules = self.named.keys().filter(|module| !module.is_empty() && self.room(module).is_none());
        let modules = modules.map(|module| format!("`{}` is in no room", module.join("/")));
        let is_there = |room: &String| self.named.keys().any(|module| module.join("/") == *room);
        let rooms = self.rooms.iter().filter(|room| !is_there(room));
        modules.chain(rooms.map(|room| format!("there is no module `{room}`"))).collect()
    }

    /// The module that defines the target of a path, or the last module found on the path.
    fn target(&self, module: &Module, path: &[String]) -> Option<Module> {
        let mut base = match path.first()?.as_str() {
            "crate" => Vec::new(),
            "self" | "super" => module.clone(),
            child => {
                let inside = [module.as_slice(), &[child.to_owned()]].concat();
                return self.named.contains_key(&inside).then(|| self.follow(module.clone(), path, 0));
            }
        };
        let up = path.iter().take_while(|name| *name == "super").count();
        base.truncate(base.len().saturating_sub(up));
        Some(self.follow(base, &path[up.max(1)..], 0))
    }

    fn follow(&self, mut module: Module, names: &[String], followed: usize) -> Module {
        /// There are no longer chains of re-exports.
        const MOST: usize = 8;
        for (index, name) in names.iter().enumerate() {
            let inside = [module.as_slice(), std::slice::from_ref(name)].concat();
            if self.named.contains_key(&inside) {
                module = inside;
                continue;
            }
            let offered = self.named.get(&module).map_or(&[][..], |named| &named.offered);
            let path = offered.iter().find(|(own, _)| own == name).map(|(_, path)| path);
            if let Some(path) = path.filter(|_| followed < MOST) {
                let rest = [path, &names[index + 1..]].concat();
                let (start, rest) = match path[0].as_str() {
                    "crate" => (Vec::new(), &rest[1..]),
                    "self" => (module, &rest[1..]),
                    "super" => {
                        let up = rest.iter().take_while(|name| *name == "super").count();
                        module.truncate(module.len().saturating_sub(up));
                        (module, &rest[up..])
                    }
                    _ => (module, &rest[..]),
                };
                return self.follow(start, rest, followed + 1);
            }
            break;
        }
        module
    }

    /// Whether a module is another one or a descendant of it in the same room.
    fn is_own(&self, module: &Module, target: &Module) -> bool {
        target.starts_with(module) && self.room(target) == self.room(module)
    }

    /// The module of the same room that defines a method; `None` if it is not the only one, or the calling
    /// module defines it.
    fn definition(&self, module: &Module, method: &Method) -> Option<&Module> {
        let defines = |(_, named): &(&Module, &Named)| named.methods.contains(method);
        let is_near = |(other, _): &(&Module, &Named)| self.room(other) == self.room(module);
        let mut found = self.named.iter().filter(is_near).filter(defines).map(|(other, _)| other);
        found.next().filter(|only| found.next().is_none() && *only != module)
    }

    /// Each module with the modules that it uses. Paths and calls to descendants in the same room do not count: a
    /// parent declares, re-exports and calls its children.
    fn edges(&self) -> BTreeSet<(&Module, Module)> {
        let mut edges = BTreeSet::new();
        for (module, named) in &self.named {
            let offered = named.offered.iter().map(|(_, path)| path);
            for path in named.paths.iter().chain(offered) {
                let Some(target) = self.target(module, path) else { continue };
                if !self.is_own(module, &target) {
                    edges.insert((module, target));
                }
            }
            for call in &named.calls {
                let Some(target) = self.definition(module, call) else { continue };
                if !self.is_own(module, target) {
                    edges.insert((module, target.clone()));
                }
            }
        }
        edges.retain(|(module, _)| !module.is_empty());
        edges
    }

    /// Imports from higher rooms. The root of the crate is above all rooms.
    pub fn upward(&self) -> BTreeSet<Upward> {
        let mut upward = BTreeSet::new();
        for (module, target) in self.edges() {
            let own = self.room(module);
            let room = match self.room(&target) {
                Some(above) if Some(above) > own => self.rooms[above].clone(),
                None if own.is_some() => "lib.rs".to_owned(),
                _ => continue,
            };
            upward.insert(Upward { from: module.join("/"), room });
        }
        upward
    }

    /// One circle of files for each room that has any: `a → b → a`.
    pub fn circles(&self) -> Vec<String> {
        let mut within: BTreeMap<Module, BTreeSet<Module>> = BTreeMap::new();
        for (module, target) in self.edges() {
            if self.room(module) == self.room(&target) {
                within.entry(module.clone()).or_default().insert(target);
            }
        }
        let within = leading_into_circles(within);
        let mut circles = BTreeMap::new();
        for start in within.keys() {
            let mut way = vec![start];
            let circle = loop {
                let next = within[way[way.len() - 1]].first().expect("a file of a circle uses another");
                if let Some(begin) = way.iter().position(|module| *module == next) {
                    way.push(next);
                    break &way[begin..];
                }
                way.push(next);
            };
            let names: Vec<String> = circle.iter().map(|module| module.join("/")).collect();
            circles.entry(self.room(start)).or_insert_with(|| names.join(" → "));
        }
        circles.into_values().collect()
    }
}
