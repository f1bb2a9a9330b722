//! Sheets and cards of the laboratory.

use super::Refused;

/// Files beside the scene.
#[rustfmt::skip]
pub(crate) const FILES: &[(&str, &str)] = &[
    ("c-drops.toml", "name = \"a\"\nsource = \"b\"\ndistribution = \"log-normal\"\nmean = \"2 kN\"\ncoefficient_of_variation = \"30 %\"\n[[drops]]\nspeed = 9\ndropped = 3\nbroken = 4\n"),
    ("c-energy.toml", "name = \"a\"\nsource = \"b\"\ndistribution = \"log-normal\"\nmean = \"2 kN\"\ncoefficient_of_variation = \"30 %\"\n[fracture_energy]\ndeviation = 0.5\n"),
    ("c-fixed.toml", "name = \"a\"\nsource = \"b\"\ndistribution = \"fixed\"\nmean = \"2 kN\"\ncoefficient_of_variation = \"30 %\"\nsample_size = 60\n"),
    ("c-key.toml", "name = \"a\"\nsource = \"b\"\ndistribution = \"log-normal\"\nmean = \"2 kN\"\ncoefficient_of_variation = \"30 %\"\nsample = 60\n"),
    ("c-law.toml", "name = \"a\"\nsource = \"b\"\ndistribution = \"normal\"\nmean = \"2 kN\"\ncoefficient_of_variation = \"30 %\"\nsample_size = 60\n"),
    ("c-mass.toml", "name = \"a\"\nsource = \"b\"\ndistribution = \"log-normal\"\nmean = \"2 kg\"\ncoefficient_of_variation = \"30 %\"\nsample_size = 60\n"),
    ("c-name.toml", "source = \"b\"\ndistribution = \"log-normal\"\nmean = \"2 kN\"\ncoefficient_of_variation = \"30 %\"\nsample_size = 60\n"),
    ("c-one.toml", "name = \"a\"\nsource = \"b\"\ndistribution = \"log-normal\"\nmean = \"2 kN\"\ncoefficient_of_variation = \"30 %\"\nsample_size = 1\n"),
    ("c-two.toml", "name = \"a\"\nsource = \"b\"\ndistribution = \"log-normal\"\nmedian = \"2 kN\"\ncoefficient_of_variation = \"30 %\"\nsample_size = 60\n"),
    ("c-zero.toml", "name = \"a\"\nsource = \"b\"\ndistribution = \"log-normal\"\nmean = \"0 kN\"\ncoefficient_of_variation = \"30 %\"\nsample_size = 60\n"),
    ("card.toml", "name = 1"),
    ("empty.csv", ""),
    ("empty.toml", ""),
    ("equal.csv", "load [N]\n2000\n2000\n2000\n"),
    ("fixed.toml", "name = \"a\"\nsource = \"b\"\ndistribution = \"fixed\"\nmean = \"2 kN\"\n"),
    ("half.csv", "speed [m/s],dropped,broken\n8,40.5,4\n"),
    ("loads.csv", "load [N]\n2000\n2100\n2350\n1900\n2240\n"),
    ("mass.csv", "load [kg]\n200\n210\n235\n"),
    ("none-named.csv", "weight [N]\n2000\n2100\n2350\n"),
    ("open.csv", "speed [m/s],dropped,broken\n8,40,41\n"),
    ("short.csv", "load [N],diameter [mm]\n2000,12\n2100\n2350,11\n"),
    ("text.csv", "load [N]\n2000\nabout 2000\n-3\n2100\n"),
    ("two.csv", "load [N]\n2000\n2100\n"),
    ("unit.csv", "load\n2000\n2100\n2200\n"),
    ("zero.csv", "speed [m/s],dropped,broken\n8,0,0\n"),
];

/// Arguments, the exit code and a part of the message.
#[rustfmt::skip]
pub(crate) const ROWS: &[Refused] = &[
    ("card --crush text.csv", 2, "text.csv:3: load [N]: `about 2000` is no number; expected a load in N, for example 2.45"),
    ("card --crush empty.csv", 2, "empty.csv: the sheet is empty; write a header such as `load [kN]` and one line for each pellet"),
    ("card --crush two.csv", 2, "two.csv: there are 2 loads; expected at least 3 and better 60 (ISO 4700): crush more pellets"),
    ("card --crush equal.csv", 2, r#"equal.csv: all 3 loads are 2000 N; a distribution cannot be fitted to one value: write what each pellet bore, or write a card with distribution = "fixed""#),
    ("card --crush unit.csv", 2, "unit.csv:1: load: the column has no unit; name it `load [kN]`, or give --unit"),
    ("card --crush unit.csv --unit kN", 2, "unit.csv: the mean load is 2.100e6 N; expected between 10 N and 100000 N for a pellet: look at the unit of the column"),
    ("card --crush unit.csv --unit kg", 2, "unit.csv:1: load: `kg` is a mass; expected a force, for example `load [kN]`"),
    ("card --crush none.csv", 2, "none.csv: cannot be read: "),
    ("card --crush .", 2, ".: cannot be read: is a directory; name a file of comma-separated values"),
    ("card --crush short.csv", 2, "short.csv:3: diameter [mm]: the value is missing; write it, or take the line out"),
    ("card --crush none-named.csv", 2, "none-named.csv:1: there is no column `load`; the columns are `weight [N]`: name one so"),
    ("card --crush mass.csv", 2, "mass.csv:1: load [kg]: `kg` is a mass; expected a force, for example `load [kN]`"),
    ("card --crush bytes.toml", 2, "bytes.toml:1: byte 0 is not UTF-8; save the file as UTF-8 text"),
    ("card --crush loads.csv --drop open.csv", 2, "open.csv:2: broken: 41 pellets broke of 40 dropped; expected at most as many"),
    ("card --crush loads.csv --drop half.csv", 2, "half.csv:2: dropped: `40.5` is no count; expected a whole number of 1 or more"),
    ("card --crush loads.csv --drop zero.csv", 2, "zero.csv:2: dropped: `0` is no count; expected a whole number of 1 or more"),
    ("card --crush loads.csv --drop loads.csv", 2, "loads.csv:1: there is no column `speed`; the columns are `load [N]`: name one so"),
    ("card --crush loads.csv --drop none.csv", 2, "none.csv: cannot be read: "),
    ("card --crush short.csv --test-diameter 12mm", 2, "short.csv:3: diameter [mm]: the value is missing; write it, or take the line out"),
    ("card --crush loads.csv --tumble 945%", 2, "invalid value '945%' for '--tumble <SHARE>': `945%` is no index; expected 0 to 1, for example 94.5%"),
    ("card --crush loads.csv --abrasion 4%", 2, "--tumble <SHARE>"),
    ("card --crush loads.csv --damage-constant 5", 2, "--drop <FILE>"),
    ("card --crush loads.csv --distribution fixed", 2, "invalid value 'fixed' for '--distribution <NAME>'\n  [possible values: log-normal, weibull]"),
    ("card --crush loads.csv --yield-pressure 0", 2, "invalid value '0' for '--yield-pressure <PRESSURE>': expected more than 0"),
    ("card --crush loads.csv -o loads.csv", 2, "loads.csv exists and is not overwritten; name another file with -o"),
    ("card --crush loads.csv -o missing/card.toml", 4, "missing/card.toml cannot be written: "),
    ("card", 2, "--crush <FILE>"),
];
