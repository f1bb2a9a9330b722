//! The table of meters made into enums: what each measures, what it has gathered, and who does it.

/// Declares `MeterKind` and `Record` from rows such as `MassFlow in mass_flow,`.
macro_rules! registry {
    ($($(#[$doc:meta])* $meter:ident in $file:ident,)*) => {
        $(pub use $file::$meter;)*

        /// What a meter measures.
        #[derive(Debug, Clone, PartialEq)]
        #[non_exhaustive]
        pub enum MeterKind {
            $($(#[$doc])* $meter($meter),)*
        }

        /// What a meter has gathered so far.
        #[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
        pub(crate) enum Record {
            $($meter(<$meter as Instrument>::Record),)*
        }

        impl MeterKind {
            /// The names of all kinds.
            pub const NAMES: &[&str] = &[$(<$meter as Instrument>::NAME),*];

            /// Name in scenes, as `mass-flow`.
            pub fn name(&self) -> &'static str {
                match self {
                    $(Self::$meter(_) => <$meter as Instrument>::NAME,)*
                }
            }

            /// What cannot be measured: keys of the meter's table, and what is wrong there.
            pub(crate) fn mistakes(&self, setup: &Setup) -> Vec<(&'static str, String)> {
                match self {
                    $(Self::$meter(meter) => meter.mistakes(setup),)*
                }
            }

            /// The wall whose contacts it watches, by index.
            pub(crate) fn wall(&self) -> Option<usize> {
                match self {
                    $(Self::$meter(meter) => meter.wall(),)*
                }
            }

            fn record(&self) -> Record {
                match self {
                    $(Self::$meter(_) => Record::$meter(Default::default()),)*
                }
            }
        }

        impl Record {
            /// Whether it can be what a meter of this kind has gathered of so many pellets.
            pub(crate) fn fits(&self, kind: &MeterKind, pellets: usize) -> bool {
                match (kind, self) {
                    $((MeterKind::$meter(meter), Self::$meter(record)) => meter.fits(record, pellets),)*
                    _ => false,
                }
            }

            fn list(&mut self, kind: &MeterKind, model: &Model, state: &State) {
                match (kind, self) {
                    $((MeterKind::$meter(meter), Self::$meter(record)) => meter.list(record, model, state),)*
                    _ => unreachable!("records are made from the meters, in their order"),
                }
            }

            fn watch(&mut self, kind: &MeterKind, step: &Watched) {
                match (kind, self) {
                    $((MeterKind::$meter(meter), Self::$meter(record)) => meter.watch(record, step),)*
                    _ => unreachable!("records are made from the meters, in their order"),
                }
            }

            fn discharge(&mut self, kind: &MeterKind, age: f64) {
                match (kind, self) {
                    $((MeterKind::$meter(meter), Self::$meter(record)) => meter.discharge(record, age),)*
                    _ => unreachable!("records are made from the meters, in their order"),
                }
            }

            fn values(&self, kind: &MeterKind, model: &Model, state: &State) -> Values {
                match (kind, self) {
                    $((MeterKind::$meter(meter), Self::$meter(record)) => meter.values(record, model, state),)*
                    _ => unreachable!("records are made from the meters, in their order"),
                }
            }

            fn patches(&self, kind: &MeterKind) -> Option<PatchTable> {
                match (kind, self) {
                    $((MeterKind::$meter(meter), Self::$meter(record)) => meter.patches(record),)*
                    _ => unreachable!("records are made from the meters, in their order"),
                }
            }
        }
    };
}

pub(super) use registry;
