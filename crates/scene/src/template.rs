//! Scenes to start from.

/// A commented starter scene.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Template {
    /// Short name.
    pub name: &'static str,
    /// What it shows, in a line.
    pub description: &'static str,
    /// The scene.
    pub text: &'static str,
}

/// Every template.
pub static TEMPLATES: &[Template] = &[
    Template {
        name: "hopper",
        description: "a conical hopper with a gate that opens",
        text: include_str!("templates/hopper.toml"),
    },
    Template {
        name: "chute",
        description: "a feed onto an inclined chute",
        text: include_str!("templates/chute.toml"),
    },
    Template {
        name: "drop",
        description: "one pellet dropped on steel",
        text: include_str!("templates/drop.toml"),
    },
];
