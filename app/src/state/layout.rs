//! How the page is laid out: which panels there are, which of them are folded away, and how they share the room.
//!
//! The program stands on the left; on the right the terminal stands above the scope, which has the inputs and outputs.
//! Where the controller has a front panel, either that or the terminal stands above the scope. Where there is room for one panel alone, it is the one that is `shown`.

pub use super::project::Layout;

/// A panel.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[allow(missing_docs)]
pub enum Panel {
    Program,
    Front,
    Terminal,
    Scope,
}

/// What parts two panels, and can be moved.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Divider {
    /// Between the program and what is right of it.
    Program,
    /// Between the terminal and the scope.
    Terminal,
    /// Between the front panel, or the terminal in its place, and the scope.
    Front,
}

/// What a panel has of the room at least, in thousandths.
pub const LEAST: u16 = 200;
/// What it has at most.
pub const MOST: u16 = 800;
/// So far a key moves a divider.
pub const STEP: u16 = 25;

impl Panel {
    /// All there are, in the order of the page.
    pub const ALL: [Panel; 4] = [Panel::Program, Panel::Front, Panel::Terminal, Panel::Scope];

    /// In a layout.
    pub fn name(self) -> &'static str {
        match self {
            Panel::Program => "program",
            Panel::Front => "front",
            Panel::Terminal => "terminal",
            Panel::Scope => "scope",
        }
    }

    /// For people.
    pub fn title(self) -> &'static str {
        match self {
            Panel::Program => "Program",
            Panel::Front => "Panel",
            Panel::Terminal => "Terminal",
            Panel::Scope => "Scope",
        }
    }
}

impl Divider {
    /// The panel whose share it sets.
    fn name(self) -> &'static str {
        match self {
            Divider::Program => "program",
            Divider::Terminal => "terminal",
            Divider::Front => "front",
        }
    }

    /// What that panel has until the user moves it.
    pub fn usual(self) -> u16 {
        match self {
            Divider::Program => 450,
            Divider::Terminal => 360,
            Divider::Front => 580,
        }
    }
}

impl Layout {
    /// What the panel before a divider has of the room, in thousandths.
    pub fn share(&self, divider: Divider) -> u16 {
        let share = self.shares.get(divider.name()).copied();
        share.unwrap_or(divider.usual()).clamp(LEAST, MOST)
    }

    /// Moves a divider; too far is as far as it goes.
    pub fn move_divider(&mut self, divider: Divider, share: u16) {
        self.shares
            .insert(divider.name().to_owned(), share.clamp(LEAST, MOST));
    }

    /// Whether a panel is folded away.
    pub fn is_folded(&self, panel: Panel) -> bool {
        self.folded.iter().any(|name| name == panel.name())
    }

    /// Folds a panel away, or opens it. A front panel has the terminal's place. Terminal and scope are not both folded: one has the room of the other.
    pub fn fold(&mut self, panel: Panel, folded: bool) {
        let panel = match panel {
            Panel::Front => Panel::Terminal,
            panel => panel,
        };
        self.folded.retain(|name| name != panel.name());
        if !folded {
            return;
        }
        self.folded.push(panel.name().to_owned());
        match panel {
            Panel::Program | Panel::Front => {}
            Panel::Terminal => self.fold(Panel::Scope, false),
            Panel::Scope => self.fold(Panel::Terminal, false),
        }
    }

    /// The panel that is shown where there is room for one, of a controller that has a front panel or not.
    pub fn shown(&self, has_front: bool) -> Panel {
        let usual = if has_front {
            Panel::Front
        } else {
            Panel::Terminal
        };
        let shown = self.shown.as_deref();
        let named = Panel::ALL
            .into_iter()
            .find(|panel| shown == Some(panel.name()));
        match named {
            None | Some(Panel::Front) => usual,
            Some(panel) => panel,
        }
    }

    /// Whether the front panel stands above the scope, if there is one.
    pub fn is_front_up(&self) -> bool {
        self.shown(true) != Panel::Terminal
    }

    /// Brings a panel into sight.
    pub fn show(&mut self, panel: Panel) {
        self.shown = Some(panel.name().to_owned());
        self.fold(panel, false);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_divider_stays_where_it_was_put_and_within_its_bounds() {
        let mut layout = Layout::default();
        assert_eq!(layout.share(Divider::Program), 450);
        layout.move_divider(Divider::Program, 600);
        assert_eq!(
            (
                layout.share(Divider::Program),
                layout.share(Divider::Terminal)
            ),
            (600, 360)
        );
        layout.move_divider(Divider::Terminal, 990);
        assert_eq!(layout.share(Divider::Terminal), MOST);
        // From a file that someone has changed.
        layout.shares.insert("terminal".to_owned(), 3);
        assert_eq!(layout.share(Divider::Terminal), LEAST);
    }

    #[test]
    fn the_right_side_is_never_empty() {
        let mut layout = Layout::default();
        layout.fold(Panel::Scope, true);
        layout.fold(Panel::Terminal, true);
        assert!(layout.is_folded(Panel::Terminal) && !layout.is_folded(Panel::Scope));
        layout.fold(Panel::Scope, true);
        assert!(layout.is_folded(Panel::Scope) && !layout.is_folded(Panel::Terminal));
        layout.fold(Panel::Program, true);
        assert!(layout.is_folded(Panel::Program) && layout.is_folded(Panel::Scope));
    }

    #[test]
    fn what_is_shown_is_open() {
        let mut layout = Layout::default();
        assert_eq!(layout.shown(false), Panel::Terminal);
        layout.fold(Panel::Program, true);
        layout.show(Panel::Program);
        assert_eq!(layout.shown(false), Panel::Program);
        assert!(!layout.is_folded(Panel::Program));
        layout.shown = Some("of another version".to_owned());
        assert_eq!(layout.shown(false), Panel::Terminal);
    }

    #[test]
    fn a_front_panel_stands_in_the_terminals_place() {
        let mut layout = Layout::default();
        assert_eq!(layout.shown(true), Panel::Front);
        layout.show(Panel::Terminal);
        assert!(!layout.is_front_up());
        layout.fold(Panel::Terminal, true);
        layout.show(Panel::Front);
        assert!(layout.is_front_up() && !layout.is_folded(Panel::Terminal));
        assert_eq!(layout.shown(false), Panel::Terminal, "another has none");
    }
}
