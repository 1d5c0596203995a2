//! A canvas and its context.
//!
//! In: positions, colours and widths in CSS pixels, or paths in mm. Out: device pixels. Knows nothing of
//! scenes.

use js_sys::Array;
use wasm_bindgen::{Clamped, JsCast, JsValue};
use web_sys::{ImageBitmap, ImageData, OffscreenCanvas, OffscreenCanvasRenderingContext2d, Path2d};

use super::super::camera::{BOTTOM_RULER, LEFT_RULER, Pixel};
use super::super::clip::Piece;
use super::super::view::View;

/// The dash pattern of a line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Dash {
    /// Without gaps.
    Solid,
    /// A dash and a gap, CSS pixels.
    Broken(f64, f64),
    /// The dash-dot of centre lines, CSS pixels: dash, gap, dot, gap.
    Center([f64; 4]),
}

/// A canvas to draw on.
#[derive(Debug)]
pub struct Pen {
    canvas: OffscreenCanvas,
    context: OffscreenCanvasRenderingContext2d,
}

impl Pen {
    /// A pen for a canvas.
    pub fn new(canvas: OffscreenCanvas) -> Result<Self, JsValue> {
        let context =
            canvas.get_context("2d")?.ok_or_else(|| js_sys::Error::new("this canvas has no 2d context"))?;
        Ok(Self { canvas, context: context.unchecked_into() })
    }

    /// Sets the size of the canvas to that of the view, and resets the state of the context.
    pub fn begin(&self, view: &View) -> Result<(), JsValue> {
        let (width, height) = view.device_size();
        if (self.canvas.width(), self.canvas.height()) != (width, height) {
            self.canvas.set_width(width);
            self.canvas.set_height(height);
        }
        self.context.set_global_alpha(1.0);
        self.context.set_line_join("round");
        self.page(view)
    }

    /// Releases the memory of the canvas, which is then blank.
    pub fn release(&self) {
        self.canvas.set_width(1);
        self.canvas.set_height(1);
    }

    /// Takes the image off the canvas, which is then blank.
    pub fn take_image(&self) -> Result<ImageBitmap, JsValue> {
        self.canvas.transfer_to_image_bitmap()
    }

    /// Sets the coordinates to CSS pixels.
    pub fn page(&self, view: &View) -> Result<(), JsValue> {
        let ratio = view.pixel_ratio();
        self.context.set_transform(ratio, 0.0, 0.0, ratio, 0.0, 0.0)
    }

    /// Sets the coordinates to mm, with Z to the right and X up (down for a front turret). `width` and `dash`
    /// stay in CSS pixels.
    pub fn world(&self, view: &View, width: f64, dash: Dash, colour: &str) -> Result<(), JsValue> {
        let (camera, ratio) = (view.camera(), view.pixel_ratio());
        let zero = camera.to_screen(Default::default());
        let (across, up) = (camera.scale() * ratio, camera.upward() * ratio);
        self.context.set_transform(across, 0.0, 0.0, -up, zero.x * ratio, zero.y * ratio)?;
        self.context.set_stroke_style_str(colour);
        self.context.set_line_width(width / camera.scale());
        self.dash(dash, 1.0 / camera.scale())
    }

    /// Strokes a path with the current line style.
    pub fn stroke(&self, path: &Path2d) {
        self.context.stroke_with_path(path);
    }

    /// Sets the opacity for the following operations: 0 transparent, 1 opaque.
    pub fn opacity(&self, opacity: f64) {
        self.context.set_global_alpha(opacity);
    }

    /// Clips the following operations to the area inside the rulers.
    pub fn clip(&self, view: &View) -> Result<(), JsValue> {
        let size = view.camera().size();
        self.context.save();
        self.page(view)?;
        self.context.begin_path();
        self.context.rect(LEFT_RULER, 0.0, size.width - LEFT_RULER, size.height - BOTTOM_RULER);
        self.context.clip();
        Ok(())
    }

    /// Ends the clipping of [`Pen::clip`] and restores the state before it.
    pub fn unclip(&self) {
        self.context.restore();
    }

    /// Clears the canvas.
    pub fn clear(&self) -> Result<(), JsValue> {
        self.context.set_transform(1.0, 0.0, 0.0, 1.0, 0.0, 0.0)?;
        self.context.clear_rect(0.0, 0.0, self.canvas.width().into(), self.canvas.height().into());
        Ok(())
    }

    /// Sets the pixels of rows `width` device pixels wide, from the row `top` on: red, green, blue and
    /// opacity of each.
    pub fn put(&self, pixels: &[u8], width: usize, top: usize) -> Result<(), JsValue> {
        let image = ImageData::new_with_u8_clamped_array(Clamped(pixels), width as u32)?;
        self.context.put_image_data(&image, 0.0, top as f64)
    }

    /// Copies an image that was drawn for the view `then`, transformed to the view `now`.
    pub fn copy_moved(&self, from: &Pen, then: &View, now: &View) -> Result<(), JsValue> {
        let place = |view: &View| {
            let zero = view.camera().to_screen(Default::default());
            (
                view.camera().scale() * view.pixel_ratio(),
                zero.x * view.pixel_ratio(),
                zero.y * view.pixel_ratio(),
            )
        };
        let ((before, x, y), (after, new_x, new_y)) = (place(then), place(now));
        let grown = after / before;
        self.context.set_transform(grown, 0.0, 0.0, grown, new_x - grown * x, new_y - grown * y)?;
        self.context.draw_image_with_offscreen_canvas(&from.canvas, 0.0, 0.0)
    }

    /// Copies an image of the same size.
    pub fn copy(&self, from: &Pen) -> Result<(), JsValue> {
        self.context.set_transform(1.0, 0.0, 0.0, 1.0, 0.0, 0.0)?;
        self.context.draw_image_with_offscreen_canvas(&from.canvas, 0.0, 0.0)
    }

    /// Fills a rectangle between two corners, CSS pixels.
    pub fn block(&self, colour: &str, from: Pixel, to: Pixel) {
        self.context.set_fill_style_str(colour);
        self.context.fill_rect(from.x, from.y, to.x - from.x, to.y - from.y);
    }

    /// Fills polygons, corners in CSS pixels.
    pub fn fill<'a>(&self, colour: &str, polygons: impl Iterator<Item = &'a [Pixel]>) {
        self.context.set_fill_style_str(colour);
        self.context.begin_path();
        for corners in polygons {
            self.trace(corners);
        }
        self.context.fill();
    }

    /// Draws the outline of a polygon, corners and width in CSS pixels.
    pub fn outline(&self, colour: &str, corners: &[Pixel], width: f64) {
        self.context.set_stroke_style_str(colour);
        self.context.set_line_width(width);
        let _ = self.dash(Dash::Solid, 1.0);
        self.context.begin_path();
        self.trace(corners);
        self.context.stroke();
    }

    /// Fills dots of a radius, CSS pixels.
    pub fn dots(
        &self,
        colour: &str,
        places: impl Iterator<Item = Pixel>,
        radius: f64,
    ) -> Result<(), JsValue> {
        self.context.set_fill_style_str(colour);
        self.context.begin_path();
        for place in places {
            self.context.move_to(place.x + radius, place.y);
            self.context.arc(place.x, place.y, radius, 0.0, std::f64::consts::TAU)?;
        }
        self.context.fill();
        Ok(())
    }

    /// Draws a ring of a radius and a width, CSS pixels.
    pub fn ring(&self, colour: &str, at: Pixel, radius: f64, width: f64) -> Result<(), JsValue> {
        self.context.set_stroke_style_str(colour);
        self.context.set_line_width(width);
        self.dash(Dash::Solid, 1.0)?;
        self.context.begin_path();
        self.context.arc(at.x, at.y, radius, 0.0, std::f64::consts::TAU)?;
        self.context.stroke();
        Ok(())
    }

    /// Draws straight lines of a width, CSS pixels.
    pub fn lines(&self, colour: &str, width: f64, lines: impl Iterator<Item = [Pixel; 2]>) {
        self.context.set_stroke_style_str(colour);
        self.context.set_line_width(width);
        let _ = self.dash(Dash::Solid, 1.0);
        self.context.begin_path();
        for [from, to] in lines {
            self.context.move_to(from.x, from.y);
            self.context.line_to(to.x, to.y);
        }
        self.context.stroke();
    }

    /// Draws pieces of lines, corners and width in CSS pixels. The dashes are at the same positions as on the
    /// whole line.
    pub fn polylines(&self, colour: &str, pieces: &[Piece], width: f64, dash: Dash) -> Result<(), JsValue> {
        self.context.set_stroke_style_str(colour);
        self.context.set_line_width(width);
        self.dash(dash, 1.0)?;
        self.context.begin_path();
        for piece in pieces {
            if dash != Dash::Solid {
                self.context.set_line_dash_offset(piece.before);
                self.context.begin_path();
            }
            for (index, at) in piece.corners.iter().enumerate() {
                match index {
                    0 => self.context.move_to(at.x, at.y),
                    _ => self.context.line_to(at.x, at.y),
                }
            }
            if dash != Dash::Solid {
                self.context.stroke();
            }
        }
        if dash == Dash::Solid {
            self.context.stroke();
        }
        self.context.set_line_dash_offset(0.0);
        Ok(())
    }

    /// Draws vertical and horizontal lines that fill whole device pixels, about one CSS pixel wide.
    pub fn hairlines(
        &self,
        view: &View,
        colour: &str,
        dash: Dash,
        lines: impl Iterator<Item = (Pixel, Pixel)>,
    ) -> Result<(), JsValue> {
        let ratio = view.pixel_ratio();
        let width = ratio.round().max(1.0);
        let sharp = |value: f64| (value * ratio - width / 2.0).round() + width / 2.0;
        self.context.set_transform(1.0, 0.0, 0.0, 1.0, 0.0, 0.0)?;
        self.context.set_stroke_style_str(colour);
        self.context.set_line_width(width);
        self.dash(dash, ratio)?;
        self.context.begin_path();
        for (from, to) in lines {
            self.context.move_to(sharp(from.x), sharp(from.y));
            self.context.line_to(sharp(to.x), sharp(to.y));
        }
        self.context.stroke();
        self.page(view)
    }

    /// Writes a text at a position.
    pub fn write(&self, text: &Text, at: Pixel, colour: &str) -> Result<(), JsValue> {
        self.context.set_font(text.font);
        self.context.set_text_align(text.align);
        self.context.set_text_baseline(text.baseline);
        self.context.set_fill_style_str(colour);
        self.context.fill_text(text.text, at.x, at.y)
    }

    fn trace(&self, corners: &[Pixel]) {
        for (index, corner) in corners.iter().enumerate() {
            match index {
                0 => self.context.move_to(corner.x, corner.y),
                _ => self.context.line_to(corner.x, corner.y),
            }
        }
        self.context.close_path();
    }

    /// Sets the dash pattern, with lengths in multiples of `unit`.
    fn dash(&self, dash: Dash, unit: f64) -> Result<(), JsValue> {
        let lengths: &[f64] = match &dash {
            Dash::Solid => &[],
            Dash::Broken(line, gap) => &[*line, *gap],
            Dash::Center(lengths) => lengths,
        };
        let list = Array::new();
        for length in lengths {
            list.push(&JsValue::from_f64(length * unit));
        }
        self.context.set_line_dash(&list)
    }
}

/// Red, green and blue of CSS colours, determined by drawing a pixel in each.
pub fn rgb<const COUNT: usize>(colours: [&str; COUNT]) -> Result<[[u8; 3]; COUNT], JsValue> {
    let probe = Pen::new(OffscreenCanvas::new(COUNT as u32, 1)?)?;
    for (at, colour) in colours.into_iter().enumerate() {
        probe.block(colour, Pixel::new(at as f64, 0.0), Pixel::new(at as f64 + 1.0, 1.0));
    }
    let pixels = probe.context.get_image_data(0.0, 0.0, COUNT as f64, 1.0)?.data();
    Ok(std::array::from_fn(|at| [pixels[4 * at], pixels[4 * at + 1], pixels[4 * at + 2]]))
}

/// A text on the canvas.
#[derive(Clone, Copy, Debug)]
pub struct Text<'a> {
    /// The text itself.
    pub text: &'a str,
    /// A CSS font.
    pub font: &'a str,
    /// Horizontal alignment, a value of `textAlign`.
    pub align: &'a str,
    /// Vertical alignment, a value of `textBaseline`.
    pub baseline: &'a str,
}
