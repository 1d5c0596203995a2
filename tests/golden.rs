//! The reviewed pictures of the gallery. `UPDATE_EXPECT=1 cargo test --test it golden::` regenerates them;
//! look at each changed one before you commit it.

use crate::fixtures;

use expect_test::expect_file;
use fixtures::gallery;
use gcode_playground::analyze;
use gcode_playground::machine::SimulationResult;
use gcode_playground::run::Analysis;
use gcode_playground::scene::face::Face;
use gcode_playground::scene::svg::{SvgOptions, section as section_of, svg};
use gcode_playground::setup::Setup;

/// Maximum size of a picture, bytes.
const LARGEST: usize = 40_000;

fn read(path: &str) -> String {
    std::fs::read_to_string(path).unwrap_or_else(|error| panic!("{path}: {error}"))
}

fn analysis(id: &str) -> Analysis {
    let setup = Setup::from_json(&read(&format!("tests/programs/{id}/setup.json"))).expect("a setup");
    analyze(read(&format!("tests/programs/{id}/program.nc")).as_bytes(), &setup)
}

fn section(Analysis { motions, setup, .. }: &Analysis) -> String {
    let x_plus = setup.machine.turret.into();
    let simulation = SimulationResult::of(motions, setup);
    section_of(motions, Some(&simulation), &SvgOptions { x_plus, ..SvgOptions::default() })
}

fn face(Analysis { motions, setup, .. }: &Analysis) -> Option<String> {
    let simulation = SimulationResult::of(motions, setup);
    let face = Face::of(motions, &simulation)?;
    let work = face.work(&simulation, None);
    // An end face is about as high as wide; the default width is for half-sections.
    Some(svg(&face.moves().scene(work.as_ref()), &SvgOptions { width: 720.0, ..SvgOptions::default() }))
}

#[test]
fn pictures_are_the_committed_ones() {
    let mut names = Vec::new();
    for id in gallery() {
        let analysis = analysis(&id);
        let pictures = [(id.clone(), Some(section(&analysis))), (format!("{id}.face"), face(&analysis))];
        for (name, picture) in pictures {
            let Some(picture) = picture else { continue };
            assert!(picture.len() < LARGEST, "{name}: {} bytes", picture.len());
            expect_file![format!("golden/{name}.svg")].assert_eq(&picture);
            names.push(format!("{name}.svg"));
        }
    }
    let files = std::fs::read_dir("tests/golden").expect("a folder");
    let mut left: Vec<_> = files.filter_map(|file| file.ok()?.file_name().into_string().ok()).collect();
    left.retain(|file| !names.contains(file));
    assert!(left.is_empty(), "pictures without a program: {left:?}");
}
