//! Each error, and the nearest correct path.

use super::*;

#[test]
fn start_up_and_cancel_on_an_arc_are_faults() {
    let arc = arc(1, at(20.0, 0.0), at(30.0, -5.0), at(20.0, -5.0), Turn::Counterclockwise);
    let after = line(2, at(30.0, -5.0), at(30.0, -10.0));
    let first = run(Side::Right, nose(0.8, 3), &[arc], None);
    assert_eq!(faults(&first), [CompensationError { id: 1, reason: Reason::ArcAtSwitch }]);
    // The next straight move starts instead.
    let then = run(Side::Right, nose(0.8, 3), &[arc, after, line(3, after.to, at(30.0, -20.0))], None);
    assert_eq!((faults(&then).len(), then.len()), (1, 3));
    // An arc right after the start-up is allowed; an arc in the G40 block is not.
    let up = line(0, at(20.0, 5.0), at(20.0, 0.0));
    assert_eq!(faults(&run(Side::Right, nose(0.8, 3), &[up, arc], None)), []);
    let last = run(Side::Right, nose(0.8, 3), &[up, line(4, up.to, at(20.0, -9.0))], Some(arc));
    assert_eq!(faults(&last), [CompensationError { id: 1, reason: Reason::ArcAtSwitch }]);
}

#[test]
fn a_groove_narrower_than_the_nose_is_an_overcut() {
    let nose = nose(1.5, 8);
    let found = faults(&run(Side::Right, nose, &groove(2.9), None));
    let [CompensationError { id: 3, reason: Reason::Overcut { backwards } }] = found[..] else {
        panic!("{found:?}")
    };
    assert!((backwards - 0.1).abs() < NEAR);
    for width in [3.0, 3.1] {
        let outcomes = run(Side::Right, nose, &groove(width), None);
        assert_eq!(faults(&outcomes), []);
        assert_tangent(&moves(&outcomes), nose, &groove(width), |_, _| true);
    }
}

#[test]
fn a_valley_between_two_arcs_that_touch_is_an_overcut() {
    for radius in [0.1, 0.4, 1.2] {
        for tip in 0..=9 {
            let found = faults(&run(Side::Right, nose(radius, tip), &cusp(), None));
            assert!(
                matches!(found[..], [CompensationError { id: 3, reason: Reason::CutsIn { .. } }]),
                "{found:?}"
            );
        }
    }
    // From inside, this is the point between two hollows, and the nose goes around it.
    let nose = nose(0.4, 3);
    let outcomes = run(Side::Left, nose, &cusp(), None);
    assert_eq!(faults(&outcomes), []);
    assert_tangent(&moves(&outcomes), nose, &cusp(), |made, element| made.id.abs_diff(element.id) <= 1);
}

#[test]
fn a_short_slope_between_two_inner_corners_is_an_overcut() {
    // Two corners of 45°; each takes r·tan 22.5° = 0.331 of the slope. A step with one inner and one outer
    // corner takes nothing.
    let slope = |rise: f64| {
        lines(&[at(50.0, 5.0), at(20.0, 5.0), at(20.0, 0.0), at(20.0 + 2.0 * rise, -rise), {
            at(40.0, -rise)
        }])
    };
    let short = faults(&run(Side::Right, nose(0.8, 3), &slope(0.46), None));
    assert!(matches!(short[..], [CompensationError { id: 2, reason: Reason::Overcut { .. } }]), "{short:?}");
    assert_eq!(faults(&run(Side::Right, nose(0.8, 3), &slope(0.48), None)), []);
    let step = [at(50.0, 5.0), at(20.0, 5.0), at(20.0, 0.0), at(20.2, 0.0), at(20.2, -10.0)];
    assert_eq!(faults(&run(Side::Right, nose(0.8, 3), &lines(&step), None)), []);
}

#[test]
fn an_arc_swallowed_by_its_corners_is_an_overcut() {
    // A hollow of radius 3 between two faces; the nose would meet both before it reaches the arc.
    let hollow = |half: f64| {
        let (a, b) = (Point::new(10.0, -half), Point::new(10.0, half));
        let center = Point::new(10.0 + (9.0 - half * half).sqrt(), 0.0);
        vec![
            line(0, Point::new(20.0, -10.0), Point::new(16.0, -half)),
            line(1, Point::new(16.0, -half), a),
            arc(2, a, b, center, Turn::Counterclockwise),
            line(3, b, Point::new(16.0, half)),
        ]
    };
    let found = faults(&run(Side::Left, nose(2.0, 0), &hollow(1.9), None));
    assert!(matches!(found[..], [CompensationError { id: 2, reason: Reason::Overcut { .. } }]), "{found:?}");
    for half in [2.0, 2.1, 2.9] {
        let outcomes = run(Side::Left, nose(2.0, 0), &hollow(half), None);
        assert_eq!(faults(&outcomes), [], "{half}");
        assert_tangent(&moves(&outcomes), nose(2.0, 0), &hollow(half), |_, _| true);
    }
    let whole = moves(&run(Side::Left, nose(2.0, 0), &hollow(2.0), None));
    assert_eq!(whole[2].shape, Shape::Line, "an arc of no length is no full circle");
}

#[test]
fn a_nose_that_does_not_fit_in_an_arc_is_a_fault() {
    let fillet = |radius: f64| {
        let (start, end) = (Point::new(10.0, -10.0), Point::new(10.0 + radius, -10.0 - radius));
        [
            line(0, at(50.0, 5.0), at(20.0, 2.0)),
            line(1, at(20.0, 2.0), start),
            arc(2, start, end, Point::new(10.0 + radius, -10.0), Turn::Clockwise),
            line(3, end, Point::new(30.0, -10.0 - radius)),
        ]
    };
    for radius in [0.5, 0.8] {
        let found = faults(&run(Side::Right, nose(0.8, 3), &fillet(radius), None));
        let [CompensationError { id: 2, reason: Reason::ArcRadius { radius: found } }] = found[..] else {
            panic!("{found:?}")
        };
        assert!((found - radius).abs() < NEAR);
    }
    let outcomes = run(Side::Right, nose(0.8, 3), &fillet(0.81), None);
    assert_tangent(&moves(&outcomes), nose(0.8, 3), &fillet(0.81), |_, _| true);
    // On the other side the same arc bulges towards the nose.
    assert_eq!(faults(&run(Side::Left, nose(0.8, 3), &fillet(0.5), None)), []);
}

#[test]
fn an_arc_about_its_own_start_or_end_is_a_fault() {
    let up = line(0, at(20.0, 5.0), at(20.0, 0.0));
    for center in [at(20.0, 0.0), at(30.0, -5.0)] {
        let arc = arc(1, at(20.0, 0.0), at(30.0, -5.0), center, Turn::Clockwise);
        let found = faults(&run(Side::Right, nose(0.8, 3), &[up, arc], None));
        assert_eq!(found, [CompensationError { id: 1, reason: Reason::ArcCenter }]);
    }
}

#[test]
fn a_line_that_misses_the_offset_arc_has_no_intersection() {
    // Down a face into a hollow of radius 3, in which the centre of the nose stays within 1 of the middle:
    // the face may be up to 2 inside the widest point.
    let hollow = |inside: f64| {
        let rim = Point::new(20.0 - (9.0 - (3.0 - inside) * (3.0 - inside)).sqrt(), -(3.0 - inside));
        [
            line(0, Point::new(50.0, -20.0), Point::new(40.0, rim.z)),
            line(1, Point::new(40.0, rim.z), rim),
            arc(2, rim, Point::new(20.0, 3.0), Point::new(20.0, 0.0), Turn::Counterclockwise),
            line(3, Point::new(20.0, 3.0), Point::new(40.0, 3.0)),
        ]
    };
    let path = hollow(2.01);
    let outcomes = run(Side::Left, nose(2.0, 0), &path, None);
    assert_eq!(
        faults(&outcomes),
        [CompensationError { id: 2, reason: Reason::NoIntersection { before: 1 } }]
    );
    assert_eq!(outcomes.len(), 4, "the others are still given out");
    assert_eq!(faults(&run(Side::Left, nose(2.0, 0), &hollow(1.99), None)), []);
}

#[test]
fn after_a_fault_the_path_goes_on() {
    let outcomes = run(Side::Right, nose(1.5, 8), &groove(2.0), None);
    let ids: Vec<u32> =
        outcomes.iter().map(|outcome| outcome.map_or_else(|fault| fault.id, |m| m.id)).collect();
    assert_eq!(ids, [0, 1, 2, 3, 4, 5]);
    let last = outcomes[5].unwrap();
    assert!(last.to.is_same(Point::new(20.0, -50.0)), "{last:?}");
}

#[test]
fn numbers_beyond_all_measure_do_no_harm() {
    for far in [1e160, f64::MAX, f64::INFINITY, f64::NAN] {
        let (near, away) = (at(20.0, 0.0), Point::new(far, -far));
        let path = [
            line(0, near, at(20.0, -5.0)),
            line(1, at(20.0, -5.0), away),
            arc(2, away, near, Point::new(far, 1.0), Turn::Clockwise),
            arc(3, near, away, Point::new(1.0, far), Turn::Counterclockwise),
            line(4, away, near),
        ];
        for nose in [nose(0.8, 3), nose(far, 3)] {
            assert!(!run(Side::Left, nose, &path, None).is_empty());
        }
    }
}
