//! What all plots have: a frame with axes, names for readers who do not see it, and colours that the page decides on.

use super::axis::Axis;
use plotters::coord::Shift;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

pub(super) type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;
pub(super) type Chart<'a, 'b> = ChartContext<'a, SVGBackend<'b>, Cartesian2d<Axis, Axis>>;
/// Writing to memory does not fail; plotters cannot know.
pub(super) type Drawn = Result<(), Box<dyn std::error::Error>>;

/// Pixels.
pub(super) const WIDTH: u32 = 760;
const FONT: &str = "sans-serif";
/// How many colours there are for structures and the like.
pub(super) const COLOURS: usize = 12;

/// A colour by its number in the style sheet, which has one for light and one for dark.
#[derive(Clone, Copy, Debug)]
pub(super) struct Tone(u8);

/// Words and axes.
pub(super) const INK: Tone = Tone(0xf0);
/// Lines of the grid.
pub(super) const GRID: Tone = Tone(0xf1);

impl Tone {
    pub(super) fn of(place: usize) -> Self {
        Self((place % COLOURS) as u8)
    }

    /// Plotters writes `#0000NN` for it, which becomes the class `fNN` or `sNN`.
    pub(super) fn rgb(self) -> RGBColor {
        RGBColor(0, 0, self.0)
    }
}

/// The frame of a plot.
pub(super) struct Frame<'a> {
    pub(super) id: &'a str,
    pub(super) title: &'a str,
    /// What it shows, for those who cannot see it.
    pub(super) description: &'a str,
    pub(super) x: (Axis, &'a str),
    pub(super) y: (Axis, &'a str),
    pub(super) height: u32,
    /// Room above the plot.
    pub(super) top: u32,
    /// Room to the left of the axis, and for labels to the right of the plot.
    pub(super) sides: [u32; 2],
}

impl Frame<'_> {
    /// The SVG with these marks in the frame.
    pub(super) fn draw(&self, marks: impl FnOnce(&mut Chart<'_, '_>, &Area<'_>) -> Drawn) -> String {
        let mut svg = String::new();
        self.drawn(&mut svg, marks).expect("an SVG in memory cannot fail");
        self.named(&toned(&svg))
    }

    fn drawn(&self, svg: &mut String, marks: impl FnOnce(&mut Chart<'_, '_>, &Area<'_>) -> Drawn) -> Drawn {
        let root = SVGBackend::with_string(svg, (WIDTH, self.height)).into_drawing_area();
        let mut chart = ChartBuilder::on(&root)
            .margin(8)
            .margin_top(self.top)
            .margin_right(self.sides[1])
            .x_label_area_size(44)
            .y_label_area_size(self.sides[0])
            .build_cartesian_2d(self.x.0, self.y.0)?;
        let mut mesh = chart.configure_mesh();
        mesh.x_desc(self.x.1)
            .y_desc(self.y.1)
            .axis_style(INK.rgb())
            .bold_line_style(GRID.rgb())
            .light_line_style(TRANSPARENT)
            .label_style((FONT, 15).into_font().color(&INK.rgb()))
            .axis_desc_style((FONT, 16).into_font().color(&INK.rgb()));
        if matches!(self.y.0, Axis::Rows(_)) {
            mesh.y_label_formatter(&|_| String::new());
        }
        mesh.draw()?;
        marks(&mut chart, &root)?;
        root.present()?;
        Ok(())
    }

    /// With a title and a description in it; as wide as the page lets it be.
    fn named(&self, svg: &str) -> String {
        let Self { id, title, description, height, .. } = self;
        let [title, description] = [title, description].map(|words| escaped(words));
        let inner = svg.split_once('>').map_or("", |(_, inner)| inner);
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" viewBox=\"0 0 {WIDTH} {height}\" \
             aria-labelledby=\"{id}-title {id}-desc\">\n<title id=\"{id}-title\">{title}</title>\n\
             <desc id=\"{id}-desc\">{description}</desc>{inner}"
        )
    }
}

fn escaped(words: &str) -> String {
    words.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}

/// Colours become classes, which the style sheet gives a colour for light and one for dark. An element of plotters has
/// one colour, as its `fill` or its `stroke`.
fn toned(svg: &str) -> String {
    let tones = (0..COLOURS as u8).map(Tone).chain([INK, GRID]);
    tones.fold(svg.to_owned(), |svg, Tone(number)| {
        let colour = format!("\"#0000{number:02X}\"");
        let fill = svg.replace(&format!("fill={colour}"), &format!("class=\"f{number}\""));
        fill.replace(&format!("stroke={colour}"), &format!("class=\"s{number}\""))
    })
}

/// Small words that end or begin at this pixel, centred on its height.
pub(super) fn write(area: &Area<'_>, words: &str, (x, y): (i32, i32), at: HPos) -> Drawn {
    let style = (FONT, 15).into_font().color(&INK.rgb()).pos(Pos::new(at, VPos::Center));
    area.draw(&Text::new(words.to_owned(), (x, y), style))?;
    Ok(())
}

/// A mark at this pixel, another shape for each place; also of those that share a colour, the shapes differ.
pub(super) fn mark(area: &Area<'_>, place: usize, (x, y): (i32, i32)) -> Drawn {
    let (at, colour) = ((x, y), Tone::of(place).rgb());
    match (place + place / COLOURS) % 6 {
        0 => area.draw(&Circle::new(at, 5, colour.filled()))?,
        1 => area.draw(&TriangleMarker::new(at, 6, colour.filled()))?,
        2 => area.draw(&Cross::new(at, 4, colour.stroke_width(2)))?,
        3 => area.draw(&Rectangle::new([(x - 4, y - 4), (x + 4, y + 4)], colour.filled()))?,
        4 => area.draw(&Polygon::new([(x - 6, y - 4), (x + 6, y - 4), (x, y + 6)], colour.filled()))?,
        _ => area.draw(&Polygon::new([(x, y - 6), (x + 6, y), (x, y + 6), (x - 6, y)], colour.filled()))?,
    }
    Ok(())
}

/// A ring, to be seen around another mark where both are at one place.
pub(super) fn ring(area: &Area<'_>, place: usize, at: (i32, i32)) -> Drawn {
    area.draw(&Circle::new(at, 8, Tone::of(place).rgb().stroke_width(2)))?;
    Ok(())
}

/// The style of each class that [`toned`] gives.
pub(super) fn classes() -> String {
    let colours = (0..COLOURS).map(|i| (Tone::of(i), format!("--c{i}")));
    let all = colours.chain([(INK, "--ink".to_owned()), (GRID, "--rule".to_owned())]);
    all.map(|(Tone(n), name)| format!(".f{n}{{fill:var({name})}}.s{n}{{stroke:var({name})}}\n")).collect()
}

/// 81,920.
pub(super) fn grouped(number: usize) -> String {
    let digits = number.to_string();
    let groups: Vec<&str> =
        digits.as_bytes().rchunks(3).rev().filter_map(|g| str::from_utf8(g).ok()).collect();
    groups.join(",")
}
