//! The painter drawing what egui makes of a user interface.

use egui::{Color32, RichText, Stroke, TextureOptions, pos2, vec2};
use pinhole_figure::headless::UiPass;
use pinhole_figure::painter::SoftwarePainter;
use pinhole_figure::typesetting::theme;

use crate::support;

/// A bit of everything that a panel of the program has.
fn panel(ui: &mut egui::Ui) {
    ui.heading("Camera");
    ui.label(RichText::new("u ⟂ v, ‖w‖ = 1, θ = 45°, t = −1/√2").family(theme::bold()));
    ui.label("eye → at ← up · ∥ ⟨u, v⟩ × ½ p₁² ∞");
    ui.code("w = -normalize(view)");
    let mut on = true;
    ui.checkbox(&mut on, "viewport grid");
    let mut value = 0.25;
    ui.add(egui::Slider::new(&mut value, -1.0..=1.0).text("eye x"));
    ui.horizontal(|ui| {
        let _ = ui.button("Canonical");
        let _ = ui.selectable_label(true, "world view");
        ui.hyperlink_to("the lecture", "https://example.org");
    });
    let (response, painter) = ui.allocate_painter(vec2(220.0, 60.0), egui::Sense::hover());
    let corner = response.rect.min.to_vec2();
    let to = |x: f32, y: f32| pos2(x, y) + corner;
    painter.rect(
        response.rect.shrink(2.0),
        6.0,
        Color32::from_rgba_unmultiplied(80, 120, 200, 60),
        Stroke::new(1.0, Color32::LIGHT_BLUE),
        egui::StrokeKind::Inside,
    );
    painter.line_segment([to(5.0, 55.0), to(200.0, 8.0)], Stroke::new(2.5, Color32::ORANGE));
    painter.circle(to(60.0, 30.0), 18.0, Color32::DARK_GREEN, Stroke::new(1.5, Color32::WHITE));
    painter.arrow(to(100.0, 30.0), vec2(80.0, 12.0), Stroke::new(1.5, Color32::RED));
    let texture = texture(ui);
    ui.image((texture.id(), vec2(72.0, 72.0)));
}

/// A small picture, made once.
fn texture(ctx: &egui::Context) -> egui::TextureHandle {
    let key = egui::Id::unique("picture");
    if let Some(texture) = ctx.data(|data| data.get_temp(key)) {
        return texture;
    }
    let texels = (0..64).map(|i| Color32::from_rgb(4 * i, 255 - 4 * i, 32 * (i % 8))).collect();
    let image = egui::ColorImage::new([8, 8], texels);
    let texture = ctx.load_texture("picture", image, TextureOptions::NEAREST);
    ctx.data_mut(|data| data.insert_temp(key, texture.clone()));
    texture
}

fn snapshot(name: &str, theme: egui::Theme, pixels_per_point: f32) {
    let mut harness = support::harness()
        .with_size(vec2(320.0, 340.0))
        .with_pixels_per_point(pixels_per_point)
        .with_theme(theme)
        .with_context_setup(theme::install_fonts)
        .build_ui(panel);
    harness.run();
    harness.snapshot(name);
}

#[test]
fn panel_dark() {
    snapshot("painter_panel_dark", egui::Theme::Dark, 1.0);
}

#[test]
fn panel_light_at_another_scale() {
    snapshot("painter_panel_light", egui::Theme::Light, 1.5);
}

#[test]
fn the_fast_paths_give_the_same_interface() {
    let ctx = egui::Context::default();
    theme::install_fonts(&ctx);
    let size = [400, 400];
    let screen = egui::Rect::from_min_size(egui::Pos2::ZERO, vec2(400.0, 400.0));
    let input = egui::RawInput { screen_rect: Some(screen), ..Default::default() };
    let output = ctx.run_ui(input, panel);
    let primitives = ctx.tessellate(output.shapes, output.pixels_per_point);
    let [fast, general] =
        [SoftwarePainter::default(), SoftwarePainter::triangles_only()].map(|mut painter| {
            let mut delta = output.textures_delta.clone();
            painter.set_textures(&mut delta);
            delta.clear();
            let mut pixels = vec![Color32::BLACK; size[0] * size[1]];
            painter.paint(&mut pixels, size, 1.0, &primitives);
            pixels
        });
    let mut delta = output.textures_delta;
    delta.clear();
    assert!(fast == general);
    assert!(fast.iter().any(|&pixel| pixel != Color32::BLACK));
}

#[test]
fn text_is_drawn_over_a_picture() {
    let size = [120, 40];
    let ground = Color32::from_rgb(20, 40, 80);
    let mut pixels = vec![ground; size[0] * size[1]];
    let ctx = egui::Context::default();
    theme::install_fonts(&ctx);
    let pass = UiPass::draw(&ctx, size, 2.0, |ui| {
        let font = egui::FontId::proportional(12.0);
        let painter = ui.painter();
        painter.text(pos2(4.0, 2.0), egui::Align2::LEFT_TOP, "θ = 45°", font, Color32::WHITE);
    });
    pass.paint(&mut pixels, size);
    assert!(pixels.iter().all(|pixel| pixel.a() == 255));
    let changed = pixels.iter().filter(|&&pixel| pixel != ground).count();
    assert!((100..2000).contains(&changed), "{changed} pixels");
    assert!(pixels[0] == ground && pixels[size[0] * size[1] - 1] == ground);
}
