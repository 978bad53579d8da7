//! Schedules of lattices, nets and structures.

use crate::files::dxf_pairs;
use crate::samples::all;
use plateau_archive::units::Unit;
use plateau_archive::{Archive, Attribute, Contents, LineSet, Lines};
use plateau_drawing::{Refused, ScheduleOptions, schedule};
use plateau_mesh::{DVec3, Mesh};
use serde_json::json;
use std::collections::{BTreeMap, BTreeSet};

pub fn make(archive: &Archive, query: &str) -> Result<String, Refused> {
    let pairs: Vec<(String, String)> =
        query.split('&').map(|pair| pair.split_once('=').unwrap()).map(|(a, b)| (a.into(), b.into())).collect();
    let options = ScheduleOptions::read(&pairs)?;
    schedule(archive.contents(), &options).map(|bytes| String::from_utf8(bytes).unwrap())
}

/// Returns the columns of a table by their names.
fn columns(text: &str) -> BTreeMap<String, Vec<String>> {
    let mut rows = text.split("\r\n").filter(|row| !row.is_empty()).map(|row| row.split(','));
    let names: Vec<String> = rows.next().unwrap().map(str::to_owned).collect();
    let mut columns: BTreeMap<String, Vec<String>> = names.iter().map(|name| (name.clone(), Vec::new())).collect();
    for row in rows {
        let cells: Vec<&str> = row.collect();
        assert_eq!(cells.len(), names.len());
        cells.iter().zip(&names).for_each(|(cell, name)| columns.get_mut(name).unwrap().push((*cell).into()));
    }
    columns
}

fn numbers(columns: &BTreeMap<String, Vec<String>>, name: &str) -> Vec<f64> {
    columns[name].iter().map(|cell| cell.parse().unwrap()).collect()
}

fn net(nodes: Vec<DVec3>, members: Vec<[u32; 2]>, triangles: Vec<[u32; 3]>) -> Archive {
    let name = if triangles.is_empty() { "cables" } else { "members" };
    let set = LineSet { name: name.into(), group: String::new(), lines: Lines::Segments(members), attributes: vec![] };
    Archive::new(Contents {
        generator: "plateau test".into(),
        unit: Unit::Metre,
        mesh: Mesh::new(nodes, triangles),
        line_sets: vec![set],
        statistics: "{}".into(),
        ..Contents::default()
    })
    .unwrap()
}

/// Returns a whole geodesic sphere of radius 1: every side of an icosahedron divided into `frequency` parts.
fn sphere(frequency: u32) -> (Vec<DVec3>, Vec<[u32; 2]>, Vec<[u32; 3]>) {
    let golden = 0.5 * (1.0 + 5f64.sqrt());
    let mut corners = Vec::new();
    for a in [-1.0, 1.0] {
        for b in [-golden, golden] {
            corners.extend([DVec3::new(0.0, a, b), DVec3::new(a, b, 0.0), DVec3::new(b, 0.0, a)]);
        }
    }
    let near = |a: DVec3, b: DVec3| (a.distance(b) - 2.0).abs() < 1e-9;
    let (mut nodes, mut members, mut triangles) = (Vec::<DVec3>::new(), BTreeSet::new(), Vec::new());
    for i in 0..12 {
        for j in i + 1..12 {
            for k in j + 1..12 {
                let [a, b, c] = [corners[i], corners[j], corners[k]];
                if !(near(a, b) && near(b, c) && near(c, a)) {
                    continue;
                }
                let [b, c] = if a.dot(b.cross(c)) > 0.0 { [b, c] } else { [c, b] };
                let n = frequency as i32;
                let mut number = |u: i32, v: i32| {
                    let at = (a * f64::from(n - u - v) + b * f64::from(u) + c * f64::from(v)).normalize();
                    let found = nodes.iter().position(|node| node.distance(at) < 1e-9);
                    found.unwrap_or_else(|| {
                        nodes.push(at);
                        nodes.len() - 1
                    }) as u32
                };
                for u in 0..n {
                    for v in 0..n - u {
                        triangles.push([number(u, v), number(u + 1, v), number(u, v + 1)]);
                        if u + v + 2 <= n {
                            triangles.push([number(u + 1, v), number(u + 1, v + 1), number(u, v + 1)]);
                        }
                    }
                }
            }
        }
    }
    for [a, b, c] in &triangles {
        members.extend([[a, b], [b, c], [c, a]].map(|[a, b]| [*a.min(b), *a.max(b)]));
    }
    (nodes, members.into_iter().collect(), triangles)
}

fn counts(kinds: &[String]) -> Vec<usize> {
    let mut counts: BTreeMap<&String, usize> = BTreeMap::new();
    kinds.iter().for_each(|kind| *counts.entry(kind).or_default() += 1);
    let mut counts: Vec<usize> = counts.into_values().collect();
    counts.sort_unstable();
    counts
}

#[test]
fn geodesic_domes_have_the_known_lengths_and_kinds() {
    // Half of the sphere would have these members once or twice less; the whole one has 30 f² of them.
    let lengths: BTreeMap<u32, &[f64]> = [
        (2, &[0.546_533, 0.618_034][..]),
        (3, &[0.348_615, 0.403_548, 0.412_411]),
        (4, &[0.253_185, 0.294_531, 0.295_242, 0.298_588, 0.312_869, 0.324_920]),
    ]
    .into();
    let members: BTreeMap<u32, Vec<usize>> =
        [(2, vec![60, 60]), (3, vec![60, 90, 120]), (4, vec![60, 60, 60, 60, 120, 120])].into();
    let nodes: BTreeMap<u32, Vec<usize>> = [(2, vec![12, 30]), (3, vec![12, 20, 60]), (4, vec![12, 30, 60, 60])].into();
    for frequency in [2, 3, 4] {
        let (points, edges, triangles) = sphere(frequency);
        for with_triangles in [false, true] {
            let triangles = if with_triangles { triangles.clone() } else { Vec::new() };
            let archive = net(points.clone(), edges.clone(), triangles);
            let table = columns(&make(&archive, "part=members&tolerance=0.0001").unwrap());
            assert_eq!(counts(&table["kind"]), members[&frequency], "{frequency}");
            let mut found: Vec<f64> = numbers(&table, "length_m");
            found.sort_by(f64::total_cmp);
            found.dedup_by(|one, other| (*one - *other).abs() < 1e-6);
            let expected = lengths[&frequency];
            assert_eq!(found.len(), expected.len(), "{found:?}");
            assert!(found.iter().zip(expected).all(|(one, other)| (one - other).abs() < 1e-6), "{found:?}");
            // By Euler's formula a sphere of triangles with V nodes has 3 V - 6 members.
            assert_eq!((edges.len(), points.len()), (30 * (frequency * frequency) as usize, edges.len() / 3 + 2));
            // The sum of all lengths by another route.
            let sum: f64 = edges.iter().map(|&[a, b]| points[a as usize].distance(points[b as usize])).sum();
            assert!((numbers(&table, "cut_length_m").iter().sum::<f64>() - sum).abs() < 1e-9);
            let table = columns(&make(&archive, "part=nodes").unwrap());
            let firsts: Vec<usize> =
                (0..table["node"].len()).filter(|&k| k == 0 || table["node"][k] != table["node"][k - 1]).collect();
            let kinds: Vec<String> = firsts.iter().map(|&k| table["kind"][k].clone()).collect();
            assert_eq!(counts(&kinds), nodes[&frequency], "{frequency}");
        }
    }
}

/// Returns a lattice without any symmetry.
fn lattice() -> Archive {
    let at = |x: usize, y: usize| {
        let (x, y) = (x as f64, y as f64);
        DVec3::new(x + 0.1 * (3.0 * y).sin(), y + 0.2 * (2.0 * x).cos(), 0.5 * (0.7 * x + 0.4 * y).sin())
    };
    let nodes: Vec<DVec3> = (0..20).map(|k| at(k % 5, k / 5)).collect();
    let (mut members, mut triangles) = (BTreeSet::new(), Vec::new());
    for y in 0..3u32 {
        for x in 0..4 {
            let a = 5 * y + x;
            triangles.extend([[a, a + 1, a + 5], [a + 1, a + 6, a + 5]]);
        }
    }
    for [a, b, c] in &triangles {
        members.extend([[a, b], [b, c], [c, a]].map(|[a, b]| [*a.min(b), *a.max(b)]));
    }
    net(nodes, members.into_iter().collect(), triangles)
}

#[test]
fn angles_at_nodes_rebuild_every_direction() {
    for archive in [lattice(), net(sphere(3).0, sphere(3).1, Vec::new())] {
        let nodes = &archive.contents().mesh.vertices;
        let table = columns(&make(&archive, "part=nodes").unwrap());
        let vector = |name: &str, k: usize| {
            let own = ["x", "y", "z"].map(|axis| table[&format!("{name}_{axis}")][k].parse::<f64>().unwrap());
            DVec3::from_array(own)
        };
        let angles = ["azimuth_deg", "elevation_deg", "twist_deg"].map(|name| numbers(&table, name));
        let mut twists: BTreeMap<String, Vec<f64>> = BTreeMap::new();
        for k in 0..table["node"].len() {
            let (axis, zero) = (vector("axis", k), vector("zero", k));
            assert!(axis.dot(zero).abs() < 1e-12 && (axis.length() - 1.0).abs() < 1e-12);
            let ((a, b), (c, d)) = (angles[0][k].to_radians().sin_cos(), angles[1][k].to_radians().sin_cos());
            let rebuilt = (zero * b + axis.cross(zero) * a) * d + axis * c;
            let [from, to] = ["node", "to"].map(|name| nodes[table[name][k].parse::<usize>().unwrap()]);
            assert!(rebuilt.distance((to - from).normalize()) < 1e-9, "row {k}");
            twists.entry(table["member"][k].clone()).or_default().push(angles[2][k]);
            // An angle rounded to a tenth of a degree is seen.
            let rounded = (10.0 * angles[0][k]).round() / 10.0;
            let (a, b) = rounded.to_radians().sin_cos();
            let wrong = (zero * b + axis.cross(zero) * a) * d + axis * c;
            assert!((rounded - angles[0][k]).abs() < 1e-9 || wrong.distance(rebuilt) > 1e-12);
        }
        // The mean of the two axes lies between them: the twists at both ends are equal, each seen from its node.
        for (member, twist) in twists {
            assert!(twist.len() == 2 && (twist[0] - twist[1]).abs() < 1e-9, "{member} {twist:?}");
        }
    }
}

#[test]
fn setbacks_are_where_members_of_this_width_meet() {
    // Six members at 60 degrees in a plane: half of 60 mm over the tangent of 30 degrees.
    let spoke = |k: u32| {
        let (sine, cosine) = (f64::from(k) * std::f64::consts::FRAC_PI_3).sin_cos();
        DVec3::new(cosine, sine, 0.0)
    };
    let nodes: Vec<DVec3> = std::iter::once(DVec3::ZERO).chain((0..6).map(spoke)).collect();
    let archive = net(nodes, (1..7).map(|k| [0, k]).collect(), Vec::new());
    let table = columns(&make(&archive, "part=members&member_width=0.06").unwrap());
    let expected = 0.051_961_524;
    // By another route: the sides of two neighbours, 30 mm from their middles, meet at this distance along either.
    let (along, turned) = (spoke(0), spoke(1));
    let (normal, other) = (DVec3::Z.cross(along), turned.cross(DVec3::Z));
    // The point s · along + 0.03 · normal lies 0.03 from the second middle.
    let meeting = (0.03 - 0.03 * normal.dot(other)) / along.dot(other);
    assert!((meeting - expected).abs() < 1e-9, "{meeting}");
    for k in 0..6 {
        assert!((numbers(&table, "setback_from_m")[k] - expected).abs() < 1e-9);
        assert_eq!(numbers(&table, "setback_to_m")[k], 0.0);
        assert!((numbers(&table, "cut_length_m")[k] - (1.0 - expected)).abs() < 1e-9);
    }
    let table = columns(&make(&archive, "part=members&member_width=0.06&setback=0.1").unwrap());
    assert!(numbers(&table, "cut_length_m").iter().all(|length| (length - 0.8).abs() < 1e-12));
    let refused = |query: &str| match make(&archive, query).unwrap_err() {
        Refused::BadQuery(errors) => (true, errors[0].parameter.clone()),
        Refused::Unsuitable(errors) => (false, errors[0].parameter.clone()),
        other => panic!("{other:?}"),
    };
    assert_eq!(refused("part=members&setback=0.5"), (false, "setback".into()));
    assert_eq!(refused("part=members&member_width=3"), (false, "member_width".into()));
    for (query, parameter) in [
        ("part=rods", "part"),
        ("format=csv", "part"),
        ("format=dxf&part=members", "part"),
        ("part=members&format=xml", "format"),
        ("part=members&tolerance=-1", "tolerance"),
        ("part=members&setback=x", "setback"),
        ("part=nodes&setback=1", "setback"),
        ("part=cables&tolerance=1", "tolerance"),
        ("part=members&thickness=1", "thickness"),
        ("part=bends&radius=1", "radius"),
    ] {
        assert_eq!(refused(query), (true, parameter.into()), "{query}");
    }
    assert_eq!(make(&archive, "part=bends"), Err(Refused::NoPart(vec!["members", "nodes"])));
}

#[test]
fn the_drawing_in_space_has_every_member_once_on_the_layer_of_its_kind() {
    let (nodes, members, _) = sphere(3);
    let archive = net(nodes.clone(), members.clone(), Vec::new());
    let pairs = dxf_pairs(make(&archive, "format=dxf").unwrap().as_bytes());
    let kinds = columns(&make(&archive, "part=members").unwrap())["kind"].clone();
    let value = |from: usize, code: u16| {
        pairs[from + 1..].iter().take_while(|(code, _)| *code != 0).find(|(own, _)| *own == code).unwrap().1.clone()
    };
    let point =
        |from: usize, code: u16| DVec3::from_array([0, 10, 20].map(|k| value(from, code + k).parse::<f64>().unwrap()));
    let at = |kind: &str| (0..pairs.len()).filter(|&k| pairs[k] == (0, kind.to_owned())).collect::<Vec<_>>();
    let lines = at("LINE");
    assert_eq!(lines.len(), members.len());
    for (number, &line) in lines.iter().enumerate() {
        let ends = members[number].map(|node| nodes[node as usize]);
        assert_eq!([point(line, 10), point(line, 11)], ends);
        assert_eq!(value(line, 8), format!("MEMBERS_{}", kinds[number]));
    }
    let texts = at("TEXT");
    assert_eq!(texts.len(), members.len() + nodes.len());
    for (number, &text) in texts[..members.len()].iter().enumerate() {
        let ends = members[number].map(|node| nodes[node as usize]);
        assert_eq!((value(text, 1), point(text, 11)), (number.to_string(), ends[0].midpoint(ends[1])));
    }
    assert_eq!(make(&lattice(), "format=dxf&tolerance=0").map(|text| text.contains("MEMBERS_3")), Ok(true));
}

#[test]
fn cables_and_supports_have_the_figures_of_the_statistics() {
    let nodes = [[0.0, 0.0, 1.0], [3.0, 4.0, 1.0], [6.0, 0.0, 2.0]].map(DVec3::from_array).to_vec();
    let statistics = json!({
        "force_unit": "kN",
        "cables": [{ "name": "ridge, \"north\"", "force": 10.5, "force_max": 11.0, "length": 10.0,
                     "unstressed_length": 9.9, "axial_stiffness": 1000.0 }],
        "reactions": [{ "vertex": 0, "force": [3.0, 4.0, 12.0] },
                      { "vertex": 2, "boundary": 1, "point": 4, "force": [1.0, 0.0, 0.0] }],
        "edge_reactions": [{ "boundary": 2, "force": [0.0, 3.0, 4.0], "force_per_length": { "min": 0.5, "max": 2.0 } }],
    });
    let forces = Attribute::new("force", "kN", vec![10.0, 11.0]);
    let set = LineSet {
        name: "cables".into(),
        group: "ridge".into(),
        lines: Lines::Segments(vec![[0, 1], [1, 2]]),
        attributes: vec![forces],
    };
    let archive = Archive::new(Contents {
        unit: Unit::Metre,
        mesh: Mesh::new(nodes, Vec::new()),
        line_sets: vec![set],
        statistics: statistics.to_string(),
        ..Contents::default()
    })
    .unwrap();
    assert_eq!(
        make(&archive, "part=cables").unwrap(),
        "cable,name,force_kN,force_max_kN,length_m,unstressed_length_m,axial_stiffness_kN\r\n\
         0,\"ridge, \"\"north\"\"\",10.5,11.0,10.0,9.9,1000.0\r\n"
    );
    let edges = make(&archive, "part=cable_edges").unwrap().replace("\"ridge, \"\"north\"\"\"", "ridge");
    let edges = columns(&edges);
    assert_eq!(numbers(&edges, "unstressed_length_m"), [5.0 / 1.01, 26f64.sqrt() / 1.011]);
    assert_eq!((edges["edge"].join(" "), edges["force_kN"].join(" ")), ("0 1".into(), "10.0 11.0".into()));
    let reactions = make(&archive, "part=reactions").unwrap();
    assert!(reactions.ends_with(
        "0,Vertex 1,0.0,0.0,1.0,3.0,4.0,12.0,13.0\r\n2,\"Boundary 2, point 5\",6.0,0.0,2.0,1.0,0.0,0.0,1.0\r\n"
    ));
    let edge_reactions = make(&archive, "part=edge_reactions").unwrap();
    assert!(edge_reactions.ends_with("2,Boundary 3,0.0,3.0,4.0,5.0,0.5,2.0\r\n"), "{edge_reactions}");
}

#[test]
fn bends_are_listed_with_their_radius_and_allowance() {
    let (_, archive) = all().remove(3);
    let plain = columns(&make(&archive, "part=bends").unwrap());
    assert!(plain["radius_mm"].iter().all(String::is_empty));
    let table = columns(&make(&archive, "part=bends&profile=sheet-metal&thickness=1&radius=1.5&k=0.4").unwrap());
    assert_eq!(table["bridge"], plain["bridge"]);
    for k in 0..table["bend"].len() {
        let angle: f64 = table["angle_deg"][k].parse().unwrap();
        let allowance: f64 = table["bend_allowance_mm"][k].parse().unwrap();
        assert!((allowance - angle.abs().to_radians() * 1.9).abs() < 1e-12);
        assert_eq!(table["direction"][k], if angle < 0.0 { "up" } else { "down" });
        // The line is shorter than the bridge by what the panels lose at their corners.
        let lengths = [&table, &plain].map(|table| table["length_mm"][k].parse::<f64>().unwrap());
        assert!(lengths[0] < lengths[1] && lengths[0] > 0.95 * lengths[1], "{lengths:?}");
    }
}

/// Nodes with four members of the same directions up to a mirror, seen along the axis.
#[test]
fn nodes_that_are_mirror_images_are_two_kinds_and_turned_ones_are_one() {
    // Azimuths of the members of each node; the axis is up, because all members point down alike.
    let star = |azimuths: [f64; 4]| {
        azimuths.map(|azimuth: f64| {
            let (sine, cosine) = azimuth.to_radians().sin_cos();
            DVec3::new(cosine, sine, -0.3)
        })
    };
    let own = [0.0, 50.0, 170.0, 230.0];
    let stars = [star(own), star(own.map(|azimuth| azimuth + 77.0)), star(own.map(|azimuth| 33.0 - azimuth))];
    let (mut nodes, mut members, mut triangles) = (Vec::new(), Vec::new(), Vec::new());
    for (number, star) in stars.iter().enumerate() {
        let first = nodes.len() as u32;
        let centre = DVec3::new(10.0 * number as f64, 0.0, 0.0);
        nodes.push(centre);
        nodes.extend(star.map(|direction| centre + direction));
        members.extend((1..5).map(|k| [first, first + k]));
        // A triangle under the node gives it the axis z.
        let corner = |x: f64, y: f64| centre + DVec3::new(x, y, 0.0);
        nodes.extend([corner(1.0, 0.0), corner(0.0, 1.0)]);
        triangles.push([first, first + 5, first + 6]);
    }
    let table = columns(&make(&net(nodes, members, triangles), "part=nodes").unwrap());
    let kind = |node: usize| {
        let row = table["node"].iter().position(|own| *own == node.to_string()).unwrap();
        table["kind"][row].clone()
    };
    assert_eq!(kind(0), kind(7));
    assert_ne!(kind(0), kind(14));
}

/// The wheel's hub has more members than could be compared pair by pair, and the angle between neighbours is known.
#[test]
fn setbacks_at_a_node_with_many_members_are_those_of_the_nearest_one() {
    let count = 3000;
    let spoke = |k: u32| {
        let (sine, cosine) = (std::f64::consts::TAU * f64::from(k) / f64::from(count)).sin_cos();
        DVec3::new(1000.0 * cosine, 1000.0 * sine, 0.0)
    };
    let nodes: Vec<DVec3> = std::iter::once(DVec3::ZERO).chain((0..count).map(spoke)).collect();
    let archive = net(nodes, (1..=count).map(|k| [0, k]).collect(), Vec::new());
    let table = columns(&make(&archive, "part=members&member_width=0.01").unwrap());
    let expected = 0.005 / (std::f64::consts::PI / f64::from(count)).tan();
    assert!(numbers(&table, "setback_from_m").iter().all(|found| (found - expected).abs() < 1e-6 * expected));
    // Directions without any order, against all pairs.
    let archive = lattice();
    let table = columns(&make(&archive, "part=members&member_width=0.05").unwrap());
    let contents = archive.contents();
    let Lines::Segments(members) = &contents.line_sets[0].lines else { panic!() };
    let at = |node: u32| contents.mesh.vertices[node as usize];
    for (number, &[from, to]) in members.iter().enumerate() {
        let away = |[a, b]: [u32; 2]| at(if a == from { b } else { a }) - at(from);
        let own = at(to) - at(from);
        let others = members.iter().filter(|pair| pair.contains(&from) && **pair != [from, to]);
        let least = others.map(|&pair| own.angle_between(away(pair))).fold(f64::INFINITY, f64::min);
        let expected = 0.025 / (0.5 * least).tan();
        assert!((numbers(&table, "setback_from_m")[number] - expected).abs() < 1e-9, "member {number}");
    }
}
