//! Compares tensile structures with closed forms, each on three meshes. The table of `docs/validation/closed-forms.md`
//! has the results of this test. It is written again by
//!
//! ```text
//! PLATEAU_WRITE=1 cargo test -p plateau-engine --test it closed_forms
//! ```
//!
//! The order of a figure is the exponent p for which its error is proportional to the edge length to the power p, from
//! the first mesh to the third.

use crate::read;
use plateau_engine::solved::Signal;
use serde_json::{Value, json};
use std::f64::consts::PI;
use std::fmt::Write as _;

/// Smallest accepted order of convergence: of a figure, and of a figure with a stated reason for a lower order.
const LEAST_ORDER: f64 = 1.8;
const LEAST_ORDER_WITH_REASON: f64 = 1.6;
/// Largest error of a figure that does not converge with the mesh, for a stated reason.
const LARGEST_ERROR: f64 = 0.02;
/// Error below which a figure is exact at every mesh, relative to its value.
const EXACT: f64 = 1e-9;

/// A structure with closed forms.
struct Case {
    name: &'static str,
    /// Returns the request without its resolution. The argument is the number of points on each circle.
    request: Box<dyn Fn(u32) -> Value>,
    /// Numbers of triangles of the three meshes.
    triangles: [u32; 3],
    figures: Vec<Figure>,
}

struct Figure {
    name: &'static str,
    /// Place in the statistics.
    pointer: &'static str,
    exact: f64,
    formula: &'static str,
    /// Why the order may be lower than [`LEAST_ORDER`]. The table has it below the rows.
    reason: Option<&'static str>,
    /// Whether the figure has an accuracy of its own, [`LARGEST_ERROR`], in place of an order.
    has_no_order: bool,
}

/// Reason for the lower order of a cable's sag.
const SAG: &str = "The stated sag is that of the vertex farthest from the chord. This vertex stands up to half a \
    segment of the cable from the middle of the arc, at another part of a segment in each mesh, so the error is below \
    a constant times the square of the edge length, but its fraction of this bound changes from mesh to mesh.";

/// Reason for the lower order of the force of a cable of given length.
const SEGMENTS: &str = "A cable of given length is a polygon, and its error falls with the square of the number of its \
    segments. This number is a whole one and does not exactly double from mesh to mesh.";

fn figure(name: &'static str, pointer: &'static str, exact: f64, formula: &'static str) -> Figure {
    Figure { name, pointer, exact, formula, reason: None, has_no_order: false }
}

/// Returns the zero of a function between two arguments at which it has different signs, by bisection.
fn root(f: impl Fn(f64) -> f64, mut low: f64, mut high: f64) -> f64 {
    let sign = f(low) > 0.0;
    for _ in 0..200 {
        let middle = 0.5 * (low + high);
        if (f(middle) > 0.0) == sign { low = middle } else { high = middle }
    }
    0.5 * (low + high)
}

/// Returns points on a horizontal circle around the z axis.
fn circle(radius: f64, height: f64, count: u32) -> Value {
    let at = |k: u32| {
        let (sine, cosine) = (2.0 * PI * f64::from(k) / f64::from(count)).sin_cos();
        json!([radius * cosine, radius * sine, height])
    };
    (0..count).map(at).collect()
}

/// Side of the square sails. Their tension is 1.
const SIDE: f64 = 10.0;

/// Returns the case of a sail on a plane square, whose four edges are equal cables. Each cable is an arc of the radius
/// force / tension.
fn sail(name: &'static str, cable: Value, radius: f64, given: &[&str]) -> Case {
    let half = (0.5 * SIDE / radius).asin();
    let (sine, cosine) = half.sin_cos();
    let all = [
        figure(
            "area",
            "/area",
            SIDE * SIDE - 4.0 * radius * radius * (half - sine * cosine),
            "a² - 4 r² (θ - sin θ cos θ)",
        ),
        figure("length of a cable", "/cables/0/length", 2.0 * radius * half, "2 r θ"),
        Figure {
            reason: Some(SAG),
            ..figure("sag of a cable", "/cables/0/sag", radius * (1.0 - cosine), "r (1 - cos θ)")
        },
        Figure {
            reason: (cable["mode"] == "length").then_some(SEGMENTS),
            ..figure("force of a cable", "/cables/0/force", radius, "σ r")
        },
    ];
    let request = move |_| {
        let side = |k: u32| {
            let mut side = cable.clone();
            side["along"] = json!({ "boundary": 0, "from": k, "to": (k + 1) % 4 });
            side
        };
        let cables: Vec<Value> = (0..4).map(side).collect();
        json!({ "boundaries": [[[0, 0, 0], [SIDE, 0, 0], [SIDE, SIDE, 0], [0, SIDE, 0]]], "film": { "tension": 1 },
            "cables": cables })
    };
    let figures = all.into_iter().filter(|figure| !given.contains(&figure.name)).collect();
    Case { name, request: Box::new(request), triangles: [500, 2000, 8000], figures }
}

fn sails() -> Vec<Case> {
    let by = |mode: &str, value: f64| json!({ "mode": mode, "value": value });
    let arc = |radius: f64| 2.0 * radius * (0.5 * SIDE / radius).asin();
    let (length, sag, unstressed, stiffness, density) = (10.5, 1.0, 10.2, 200.0, 2.0);
    let elastic = json!({ "mode": "unstressed_length", "value": unstressed, "axial_stiffness": stiffness });
    vec![
        sail("sail, force 20", by("force", 20.0), 20.0, &["force of a cable", "sag of a cable"]),
        sail("sail, force 8", by("force", 8.0), 8.0, &["force of a cable"]),
        sail("sail by length", by("length", length), root(|r| arc(r) - length, 5.001, 1e3), &["length of a cable"]),
        sail("sail by sag", by("sag", sag), 0.5 * (25.0 + sag * sag) / sag, &["sag of a cable"]),
        sail(
            "sail by unstressed length",
            elastic,
            root(|r| r - stiffness * (arc(r) / unstressed - 1.0), 5.001, 1e3),
            &["sag of a cable"],
        ),
        sail(
            "sail by force density",
            by("force_density", density),
            root(|r| r - density * arc(r), 10.0, 1e3),
            &["sag of a cable"],
        ),
    ]
}

/// Returns the cases of a heavy cable between two points at the same height. The span is 20, and the smallest force in
/// the cable is 12.
fn heavy_cables() -> Vec<Case> {
    let (a, span) = (12.0f64, 20.0f64);
    let (sine, cosine) = ((0.5 * span / a).sinh(), (0.5 * span / a).cosh());
    let (length, sag, end) = (2.0 * a * sine, a * (cosine - 1.0), a * cosine);
    let mean = a * (0.5 * span + 0.5 * a * (span / a).sinh()) / length;
    let modes = [
        ("heavy cable by horizontal component", "horizontal_component", a),
        ("heavy cable by end tension", "end_tension", end),
        ("heavy cable by length", "length", length),
        ("heavy cable by sag", "sag", sag),
        ("heavy cable by mean force", "force", mean),
    ];
    let case = |(name, mode, value): (&'static str, &'static str, f64)| {
        let request = move |_| {
            json!({ "boundaries": [[[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]], "film": { "tension": 1 },
                "cables": [{ "points": [[0, 5, 10], [span, 5, 10]], "mode": mode, "value": value, "weight": 1 }] })
        };
        let mut figures = vec![
            figure("largest force", "/cables/0/force_max", end, "w a cosh(l/2a)"),
            figure("horizontal pull of an end", "/reactions/0/force/0", -a, "-w a"),
        ];
        if mode != "length" {
            figures.push(figure("length", "/cables/0/length", length, "2 a sinh(l/2a)"));
        }
        if mode != "sag" {
            figures.push(figure("sag", "/cables/0/sag", sag, "a (cosh(l/2a) - 1)"));
        }
        Case { name, request: Box::new(request), triangles: [200, 800, 3200], figures }
    };
    modes.into_iter().map(case).collect()
}

/// Returns the height, area and volume of a spherical cap that is less than a hemisphere. `sphere` is the radius of the
/// sphere, and `radius` that of the circle below the cap.
fn cap(sphere: f64, radius: f64) -> [f64; 3] {
    let height = sphere - (sphere * sphere - radius * radius).sqrt();
    [height, 2.0 * PI * sphere * height, PI * height * height * (3.0 * sphere - height) / 3.0]
}

/// Returns the cases of films under pressure over a circle of the radius 3.
fn caps() -> Vec<Case> {
    let (radius, pressure) = (3.0f64, 0.2f64);
    let [_, area, volume] = cap(2.0 / pressure, radius);
    // The larger part of a sphere of the radius 4.
    let height = 4.0 + (16.0f64 - radius * radius).sqrt();
    let large = PI * height * height * (12.0 - height) / 3.0;
    let [_, upper, above] = cap(2.0 / 0.3, radius);
    let [_, lower, below] = cap(1.2 / 0.3, radius);
    let over = move |extra: Value| -> Box<dyn Fn(u32) -> Value> {
        Box::new(move |count| {
            let mut request = extra.clone();
            request["boundaries"] = json!([circle(radius, 0.0, count)]);
            request
        })
    };
    let film = |name: &str, value: f64| json!({ "film": { "tension": 1 }, name: value });
    let pull = -pressure * PI * radius * radius;
    vec![
        Case {
            name: "cap of a given pressure",
            request: over(film("pressure", pressure)),
            triangles: [500, 2000, 8000],
            figures: vec![
                figure("area", "/area", area, "2 π R h, R = 2σ/p"),
                figure("volume", "/volume", volume, "π h² (3R - h) / 3"),
                figure("pull on the rim", "/edge_reactions/0/force/2", pull, "-p π a²"),
            ],
        },
        Case {
            name: "cap of a given volume",
            request: over(film("volume", volume)),
            triangles: [500, 2000, 8000],
            figures: vec![figure("pressure", "/pressure", pressure, "2σ/R"), figure("area", "/area", area, "2 π R h")],
        },
        Case {
            name: "cap beyond its hemisphere",
            request: over(film("volume", large)),
            triangles: [1000, 4000, 16_000],
            figures: vec![
                figure("pressure", "/pressure", 0.5, "2σ/R"),
                figure("area", "/area", 8.0 * PI * height, "2 π R h"),
            ],
        },
        Case {
            name: "cushion",
            request: over(json!({ "layers": [{ "tension": 1 }, { "tension": 0.6 }],
                "chambers": [{ "below": 0, "pressure": 0.3 }] })),
            triangles: [500, 2000, 8000],
            figures: vec![
                figure("area of the upper layer", "/layers/0/area", upper, "2 π R h, R = 2σ/p"),
                figure("area of the lower layer", "/layers/1/area", lower, "the same"),
                figure("volume", "/chambers/0/volume", above + below, "both caps"),
            ],
        },
    ]
}

/// Returns the radius c of the neck of the catenoid through two coaxial circles, and the height z0 of the neck. The
/// first circle has the radius `radius` and lies at z = 0. The second has the radius `other` and lies at `height`.
fn neck(radius: f64, other: f64, height: f64) -> (f64, f64) {
    let middle = |c: f64| c * (radius / c).acosh();
    let c = root(|c| c * ((height - middle(c)) / c).cosh() - other, 0.7 * other, other);
    (c, middle(c))
}

/// Returns the area of a catenoid from z = 0 to `height`.
fn catenoid_area((c, z0): (f64, f64), height: f64) -> f64 {
    PI * c * (height + 0.5 * c * ((2.0 * (height - z0) / c).sinh() + (2.0 * z0 / c).sinh()))
}

fn catenoids() -> Vec<Case> {
    let rings = |name, (radius, other, height): (f64, f64, f64)| {
        let shape = neck(radius, other, height);
        let request = move |count| {
            let boundaries = [circle(radius, 0.0, count), circle(other, height, count)];
            json!({ "boundaries": boundaries, "film": { "tension": 1 } })
        };
        let figures = vec![
            figure("area", "/area", catenoid_area(shape, height), "π c (H + c/2 (sinh(2(H - z0)/c) + sinh(2 z0/c)))"),
            figure("pull on a ring", "/edge_reactions/1/force/2", 2.0 * PI * shape.0, "2 π c σ"),
        ];
        Case { name, request: Box::new(request), triangles: [1000, 4000, 16_000], figures }
    };
    let c = neck(10.0, 10.0, 12.0).0;
    let plane = move |count| {
        let mut edge = circle(11.0, 0.0, count);
        edge.as_array_mut().expect("points").reverse();
        json!({ "boundaries": [circle(10.0, 6.0, count), edge], "film": { "tension": 1 },
            "supports": [{ "boundary": 1, "on": { "plane": { "point": [0, 0, 0], "normal": [0, 0, 1] } } }] })
    };
    let half = 0.5 * catenoid_area(neck(10.0, 10.0, 12.0), 12.0);
    vec![
        rings("film between equal rings", (10.0, 10.0, 12.0)),
        rings("film between unequal rings", (10.0, 6.0, 7.0)),
        Case {
            name: "film between a ring and a plane",
            request: Box::new(plane),
            triangles: [1000, 4000, 16_000],
            figures: vec![
                figure("area", "/area", half, "half of the catenoid"),
                figure("pull on the plane", "/edge_reactions/1/force/2", -2.0 * PI * c, "-2 π c σ"),
            ],
        },
    ]
}

/// Reason for the accuracy of the largest gap.
const GAP: &str = "The largest gap is found by bisection, each step of which solves a film near its limit. The films \
    are refined at their necks, whatever the mesh of the request, and the bisection ends within the documented accuracy \
    of 2%.";

/// Returns the cases of tubes between two rings of the radius 2. The limits of stability are the lengths π R with a
/// given pressure and 2 π R with a given volume.
fn tubes() -> Vec<Case> {
    let (radius, tension) = (2.0f64, 1.5f64);
    let tube = |name, length: f64, extra: Value, figures: Vec<Figure>| {
        let request = move |count| {
            let mut request = extra.clone();
            request["boundaries"] = json!([circle(radius, 0.0, count), circle(radius, length, count)]);
            request["film"] = json!({ "tension": tension });
            request
        };
        let mut all = vec![
            figure("area", "/area", 2.0 * PI * radius * length, "2 π R L"),
            figure("pull on a ring", "/edge_reactions/1/force/2", 2.0 * PI * radius * tension, "2 π R σ"),
        ];
        all.extend(figures);
        Case { name, request: Box::new(request), triangles: [1000, 4000, 16_000], figures: all }
    };
    let volume = PI * radius * radius * 6.0;
    vec![
        tube("tube of a given pressure", 3.0, json!({ "pressure": tension / radius }), Vec::new()),
        tube(
            "tube of a given volume",
            6.0,
            json!({ "volume": volume }),
            vec![figure("pressure", "/pressure", tension / radius, "σ / R")],
        ),
    ]
}

/// Returns the case of a valley cable of given length. The film consists of two parts of a catenoid, which meet at an
/// angle along a circle. The boundary is a sector of 1 radian: circles above and below, and meridians between them.
fn valleys() -> Vec<Case> {
    // The profile above the cable is ρ(z) = c cosh((z + z0) / c).
    let (c, z0, height) = (4.0f64, 2.0f64, 3.0f64);
    let profile = move |z: f64| c * ((z.abs() + z0) / c).cosh();
    let place = move |angle: f64, z: f64| json!([profile(z) * angle.cos(), profile(z) * angle.sin(), z]);
    let radius = profile(0.0);
    let slope = (z0 / c).sinh();
    let request = move |count: u32| {
        let half = count / 4;
        let share = move |k: u32| f64::from(k) / f64::from(half);
        let level = move |k: u32| height * (2.0 * share(k) - 1.0);
        let below = (0..half).map(|k| place(share(k), -height));
        let ahead = (0..half).map(|k| place(1.0, level(k)));
        let above = (0..half).map(|k| place(1.0 - share(k), height));
        let back = (0..half).map(|k| place(0.0, -level(k)));
        let boundary: Vec<Value> = below.chain(ahead).chain(above).chain(back).collect();
        json!({ "boundaries": [boundary], "film": { "tension": 1 }, "cables": [{ "across": [place(1.0, 0.0), place(0.0, 0.0)],
            "mode": "length", "value": radius }] })
    };
    let integral = |z: f64| c * (0.5 * z + 0.25 * c * (2.0 * (z + z0) / c).sinh());
    let figures = vec![
        figure("area", "/area", 2.0 * (integral(height) - integral(0.0)), "2 ∫ ρ √(1 + ρ'²) dz"),
        figure(
            "force of the cable",
            "/cables/0/force",
            2.0 * radius * slope / (1.0 + slope * slope).sqrt(),
            "2 σ r ρ' / √(1 + ρ'²)",
        ),
    ];
    vec![Case {
        name: "valley of a given length",
        request: Box::new(request),
        triangles: [1000, 4000, 16_000],
        figures,
    }]
}

/// Returns the case of a plane woven sail on a square. Scaled by √weft along the warp and by √warp across it, it is a
/// sail of equal stresses, so that its edges are arcs of ellipses.
fn woven_sails() -> Vec<Case> {
    let (warp, weft, half) = (2.0f64, 0.5f64, 0.4f64);
    let stretch = [weft.sqrt(), warp.sqrt()];
    // For the sides along the warp, then for those across it: mean force, length.
    let sides = [0, 1].map(|along| {
        let across = 1 - along;
        let radius = 0.5 * SIDE * stretch[along] / half.sin();
        let steps = 10_000;
        let (mut force, mut length) = (0.0, 0.0);
        for k in 0..steps {
            let turn = half * ((2.0 * f64::from(k) + 1.0) / f64::from(steps) - 1.0);
            // The direction of the arc in the scaled sail, and in the sail.
            let direction = [turn.cos() / stretch[along], turn.sin() / stretch[across]];
            let step = direction[0].hypot(direction[1]);
            // The pull of the scaled film on the arc, as a force in the sail.
            let pull = (turn.cos() * stretch[across]).hypot(turn.sin() * stretch[along]);
            force += radius * pull * step;
            length += step;
        }
        [force / length, length * radius * 2.0 * half / f64::from(steps)]
    });
    let segments = |along: usize| {
        let radius = 0.5 * SIDE * stretch[along] / half.sin();
        2.0 * radius * radius * (half - half.sin() * half.cos())
    };
    let area = SIDE * SIDE - (segments(0) + segments(1)) / (stretch[0] * stretch[1]);
    let request = move |_| {
        let side = |k: usize| {
            json!({ "along": { "boundary": 0, "from": k, "to": (k + 1) % 4 }, "mode": "force",
                "value": sides[k % 2][0] })
        };
        let cables: Vec<Value> = (0..4).map(side).collect();
        json!({ "boundaries": [[[0, 0, 0], [SIDE, 0, 0], [SIDE, SIDE, 0], [0, SIDE, 0]]], "cables": cables,
            "film": { "warp": warp, "weft": weft, "direction": { "parallel": [1, 0, 0] } } })
    };
    let length = "arc of the ellipse";
    let figures = vec![
        figure("area", "/area", area, "a² - segments of ellipses"),
        figure("length of a cable along the warp", "/cables/0/length", sides[0][1], length),
        figure("length of a cable across it", "/cables/1/length", sides[1][1], length),
    ];
    vec![Case {
        name: "woven sail, stresses 2 and 0.5",
        request: Box::new(request),
        triangles: [500, 2000, 8000],
        figures,
    }]
}

/// Returns the case of two coaxial circles of the radii 10 and 6 beyond the largest distance of a film.
fn gaps() -> Vec<Case> {
    let (radius, other, gap) = (10.0f64, 6.0f64, 20.0f64);
    // The height of the catenoid of neck c is largest for one c.
    let height = |c: f64| c * ((radius / c).acosh() + (other / c).acosh());
    let rises = |c: f64| height(c * (1.0 + 1e-7)) - height(c * (1.0 - 1e-7));
    let largest = height(root(rises, 0.05 * other, 0.99 * other));
    let request = move |count| {
        json!({ "kind": "minimal_surface", "topology": "best",
            "boundaries": [circle(radius, 0.0, count), circle(other, gap, count)] })
    };
    let figures = vec![Figure {
        reason: Some(GAP),
        has_no_order: true,
        ..figure("largest gap", "/spanning/largest_gap_fraction", largest / gap, "max c (acosh R/c + acosh r/c) / gap")
    }];
    vec![Case { name: "rings beyond the limit", request: Box::new(request), triangles: [500, 2000, 8000], figures }]
}

fn statistics(case: &Case, level: usize) -> Value {
    let mut request = (case.request)(32 << level);
    if request["kind"].is_null() {
        request["kind"] = "tensile_structure".into();
    }
    request["resolution"] = json!({ "triangles": case.triangles[level] });
    let accepted = read(request.to_string().as_bytes())
        .unwrap_or_else(|rejection| panic!("{} is refused: {rejection:?}", case.name));
    let solved = accepted.solve(&|| Signal::Continue, &|_| {});
    let solved = solved.unwrap_or_else(|unsolved| panic!("{} fails: {unsolved:?}", case.name));
    serde_json::from_str(&solved.statistics).expect("statistics are JSON")
}

#[test]
fn errors_against_closed_forms_fall_with_the_square_of_the_edge_length() {
    let mut cases: Vec<Case> = sails().into_iter().chain(heavy_cables()).chain(caps()).chain(catenoids()).collect();
    cases.extend(tubes().into_iter().chain(valleys()).chain(woven_sails()).chain(gaps()));
    if !crate::is_full() {
        // One structure in four, so that each kind has one.
        cases = cases.into_iter().step_by(4).collect();
    }
    let mut table = String::from(
        "# Closed forms\n\nFigures of tensile structures at three meshes, beside their closed forms. \
         `crates/engine/tests/it/closed_forms.rs` has the structures, and fails if an\nerror falls with less than the \
         power 1.8 of the edge length, or 1.6 where the table has a reason. A figure without an order has errors below \
         2%. It writes this file anew with `PLATEAU_WRITE=1 cargo test -p plateau-engine --test it closed_forms`.\nCircles have 32, 64 and 128 points, so \
         that the polygons come nearer to them with the mesh.\n\n| structure | figure | \
         closed form | value | error | | | order |\n| --- | --- | --- | --- | --- | --- | --- | --- |\n",
    );
    let (mut rows, mut faults, mut reasons) = (0, Vec::new(), Vec::new());
    for case in &cases {
        let levels = [0, 1, 2].map(|level| statistics(case, level));
        let triangles = levels.each_ref().map(|found| found["triangles"].as_f64().expect("a count"));
        for Figure { name, pointer, exact, formula, reason, has_no_order } in &case.figures {
            let errors = levels.each_ref().map(|found| {
                let value = found.pointer(pointer).and_then(Value::as_f64).unwrap_or(f64::NAN);
                (value / exact - 1.0).abs()
            });
            let order = 2.0 * (errors[0] / errors[2]).ln() / (triangles[2] / triangles[0]).ln();
            let is_exact = errors.iter().all(|error| *error < EXACT);
            let least = if reason.is_some() { LEAST_ORDER_WITH_REASON } else { LEAST_ORDER };
            let holds = if *has_no_order { errors.iter().all(|error| *error < LARGEST_ERROR) } else { order >= least };
            if !(is_exact || holds) {
                faults.push(format!("{}, {name}: {errors:?}, order {order:.2}", case.name));
            }
            let mut text = match (is_exact, has_no_order) {
                (true, _) => "exact".into(),
                (false, true) => "none".into(),
                (false, false) => format!("{order:.1}"),
            };
            if let Some(reason) = reason.filter(|_| !is_exact && (*has_no_order || order < LEAST_ORDER)) {
                let known = reasons.iter().position(|known| *known == reason);
                let number = known.unwrap_or_else(|| {
                    reasons.push(reason);
                    reasons.len() - 1
                });
                write!(text, " ({})", number + 1).expect("a text grows");
            }
            let [a, b, c] = errors.map(|error| format!("{error:.0e}"));
            writeln!(table, "| {} | {name} | {formula} | {exact:.6} | {a} | {b} | {c} | {text} |", case.name)
                .expect("a text grows");
            rows += 1;
        }
    }
    for (number, reason) in reasons.iter().enumerate() {
        write!(table, "\n({}) {reason}\n", number + 1).expect("a text grows");
    }
    println!("{table}");
    assert!(faults.is_empty(), "{}", faults.join("\n"));
    assert!(rows >= if crate::is_full() { 30 } else { 6 }, "{rows} rows");
    let path = crate::root().join("docs/validation/closed-forms.md");
    if std::env::var_os("PLATEAU_WRITE").is_some() {
        std::fs::write(&path, &table).expect("the file can be written");
    }
    // The errors may change with every change of the solver, and with the processor.
    let named = |text: &str| -> Vec<String> {
        let row = |line: &str| line.split('|').take(5).map(str::trim).collect::<Vec<_>>().join("|");
        text.lines().filter(|line| line.starts_with('|')).map(row).collect()
    };
    let committed = std::fs::read_to_string(&path).unwrap_or_default();
    let (committed, found) = (named(&committed), named(&table));
    assert!(found.iter().all(|row| committed.contains(row)), "docs/validation/closed-forms.md lacks rows");
    assert!(!crate::is_full() || committed == found, "docs/validation/closed-forms.md has other rows");
}
