// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/fetoscope_view.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "ui/view/depth_cue.h"
#include "ui/view/field_renderer.h"
#include "ui/view/fluid_renderer.h"
#include "ui/view/mark_renderer.h"
#include "ui/view/needle_renderer.h"
#include "ui/view/overlay_colours.h"
#include "ui/view/patch_renderer.h"
#include "ui/view/png.h"
#include "ui/view/scope_light.h"
#include "ui/view/smoke_renderer.h"
#include "ui/view/tool_boxes.h"
#include "ui/view/tool_renderer.h"

namespace placode::view {

using namespace sim;
namespace {

using Clock = std::chrono::steady_clock;
constexpr double kSlowMs = 75, kFastMs = 22;  // change of quality: 13 fps, 45 fps

double seconds_of(Clock::time_point time) {
    return std::chrono::duration<double>(time.time_since_epoch()).count();
}

}  // namespace

struct FetoscopeView::Impl {
    Impl(const ViewField& of, const ViewSettings& s);
    void draw_world(const Snapshot& snapshot, const OverlayState& overlay, int size);
    void light(GlProgram& program, const Snapshot& snapshot);
    void draw_depth(const Snapshot& snapshot, const OverlayState& overlay);
    void adapt(double ms);
    void observe(const Snapshot& snapshot);

    ViewSettings settings;
    std::unique_ptr<GlContext> context;  // before everything that lives in it
    std::vector<ToolSpec> tools;
    FieldRenderer field;
    GlProgram tool{"tissue_vertex", "tool"}, mask{"screen_vertex", "mask"};
    ToolRenderer instruments;
    NeedleRenderer needle;
    PatchRenderer patch;
    FluidRenderer fluid;
    SmokeRenderer puffs;
    MarkRenderer marks;
    DepthCue depth_cue;
    PostProcess post;
    TextPainter painter;
    Overlay overlay_painter;
    Smoke smoke;
    Lens lens;
    GlTarget picture, output;
    Camera camera;
    Quality quality, first_quality;
    FrameTimes times;
    std::vector<double> frame_ms;
    int slow = 0, fast = 0;
    uint32_t frames = 0;
    double last_time_s = -1;
    Clock::time_point last_picture{};
    unsigned error = 0;
    bool software = false, stays_simple = false;
};

namespace {

/// Maps and shaders take seconds where the processor draws: nobody shall look at a black window.
void greet(GlContext& context, const std::string& words) {
    glViewport(0, 0, context.width(), context.height());
    glClearColor(0, 0, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    TextPainter painter;
    painter.begin(context.width(), context.height(), std::max(14.0, context.height() / 46.0));
    painter.text(0.5 * context.width(), 0.5 * context.height(), words, TextSize::kNormal, kText,
                 Align::kCentre);
    painter.draw();
    glFinish();
    context.swap();
}

std::unique_ptr<GlContext> opened(const ViewSettings& s) {
    if (s.offscreen) return open_offscreen({s.width, s.height, false, s.title, {}});
    auto window = open_window({s.width, s.height, s.fullscreen, s.title, s.place, s.floating});
    if (!s.greeting.empty()) greet(*window, s.greeting);
    return window;
}

}  // namespace

FetoscopeView::Impl::Impl(const ViewField& of, const ViewSettings& s)
    : settings(s),
      context(opened(s)),
      tools(of.tools),
      field(of),
      instruments(of.tools),
      patch(of.rest),
      quality(s.quality) {
    times.renderer = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
    // A software renderer starts low instead of stuttering through its first second.
    software = times.renderer.find("llvmpipe") != std::string::npos ||
               times.renderer.find("softpipe") != std::string::npos;
    if (settings.adaptive && software) quality = software_quality(quality, s.height);
    first_quality = quality;
}

void FetoscopeView::Impl::observe(const Snapshot& snapshot) {
    smoke.update(snapshot);
    Vec3 tip(-0.022, 0, 0.038);
    bool touches = false;
    for (size_t i = 0; i < tools.size() && i < static_cast<size_t>(snapshot.tool_count); ++i) {
        if (tools[i].kind != ToolKind::kScope) continue;
        tip = snapshot.tools[i].pose.p;
        touches = snapshot.tools[i].in_contact != 0;
    }
    lens.update(snapshot, tip, touches);
}

void FetoscopeView::Impl::light(GlProgram& program, const Snapshot& snapshot) {
    program.use();
    set_light(program, camera, seen_capsules(snapshot, tools, camera), snapshot.time_s);
}

void FetoscopeView::Impl::draw_world(const Snapshot& snapshot, const OverlayState& overlay,
                                     int size) {
    field.follow(snapshot, !quality.plain);
    if (quality.shadows) field.draw_shadows(camera);
    picture.allocate(size, size, GL_RGBA16F, true, quality.samples);
    picture.begin();
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LEQUAL);
    glDisable(GL_CULL_FACE);
    glDisable(GL_BLEND);
    glClearColor(0, 0, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    mask.use();
    mask.set("depth", -1.0F);
    draw_screen_triangle();

    field.bind_maps();
    light(tool, snapshot);
    tool.set("tissue_bounce", Vec3(0.20, 0.082, 0.072));
    instruments.draw(snapshot, tool);
    needle.draw(snapshot.needle, tool);

    GlProgram& tissue = field.tissue_program(quality);
    light(tissue, snapshot);
    field.draw_tissue(tissue, quality);
    if (!snapshot.patch.empty()) {
        tool.use();
        patch.draw(snapshot, tool);
    }
    if (snapshot.fluid.columns > 0) {
        tool.use();
        fluid.draw(snapshot, tool);
    }
    draw_depth(snapshot, overlay);

    light(field.wall_program(), snapshot);
    field.draw_wall();
    if (marks.follow(snapshot, camera, overlay.show_guide)) {
        light(marks.program(), snapshot);
        marks.draw(size);
    }
    light(puffs.program(), snapshot);
    puffs.draw(smoke.puffs(), camera);
    picture.resolve();
}

// Onto field and back beyond it; feet are looked for even where only steps need them.
void FetoscopeView::Impl::draw_depth(const Snapshot& snapshot, const OverlayState& overlay) {
    if (!overlay.depth_aid && overlay.practice.steps.empty()) return;
    depth_cue.update(snapshot, tools, field.around_the_tips());
    if (!overlay.depth_aid) return;
    light(depth_cue.program(), snapshot);
    depth_cue.draw();
}

// Steps the size of the computed picture, never the window. Needs a run of slow (or fast) pictures,
// so that one hiccup changes nothing.
void FetoscopeView::Impl::adapt(double ms) {
    frame_ms.push_back(ms);
    if (frame_ms.size() > 200) frame_ms.erase(frame_ms.begin(), frame_ms.begin() + 100);
    std::vector<double> sorted = frame_ms;
    std::sort(sorted.begin(), sorted.end());
    times.p99_ms = sorted[std::min(sorted.size() - 1, sorted.size() * 99 / 100)];
    times.mean_ms += (ms - times.mean_ms) * (times.mean_ms > 0 ? 0.1 : 1.0);
    if (!settings.adaptive) return;
    slow = ms > kSlowMs ? slow + 1 : 0;
    fast = ms < kFastMs ? fast + 1 : 0;
    if (slow >= 8) {
        slow = 0;
        (void)make_simpler(quality);
    } else if (fast >= 90 && !stays_simple) {
        fast = 0;
        (void)make_richer(quality);
    }
}

FetoscopeView::FetoscopeView(const ViewField& field, const ViewSettings& settings)
    : impl_(std::make_unique<Impl>(field, settings)) {}
FetoscopeView::~FetoscopeView() {
    try {
        impl_->context->make_current();
    } catch (const ViewError&) {
        // What is drawn with by another thread cannot be taken apart on this one.
        static_cast<void>(impl_.release());
    }
}

void FetoscopeView::let_go() noexcept { impl_->context->let_go(); }

bool FetoscopeView::draw(const Snapshot& snapshot, const OverlayState& overlay) {
    Impl& s = *impl_;
    const int width = s.context->width(), height = s.context->height();
    if (width < 16 || height < 16 || snapshot.x.empty()) return false;
    s.context->make_current();
    const auto start = Clock::now();
    s.camera = camera_of(snapshot, s.tools);
    s.observe(snapshot);
    PostSettings post;
    post.circle = picture_circle(width, height);
    const int size = std::max(
        64, static_cast<int>(std::lround(2 * post.circle.radius * s.quality.render_scale / 8)) * 8);
    s.draw_world(snapshot, overlay, size);

    post.width = width;
    post.height = height;
    post.dt_s = s.last_time_s < 0 ? 0 : std::clamp(snapshot.time_s - s.last_time_s, 0.0, 1.0);
    // In a window the iris follows the watcher's clock: the simulation may be paused or slow.
    if (!s.settings.offscreen && s.frames > 0) {
        post.dt_s = std::chrono::duration<double>(start - s.last_picture).count();
    }
    s.last_picture = start;
    s.last_time_s = snapshot.time_s;
    post.haze = s.smoke.haze();
    post.lens = &s.lens;
    post.dim = overlay.menu.shown ? 0.45 : 1.0;
    post.noise_seed = ++s.frames;
    // Always through a target of our own: what a window shows cannot be read back reliably.
    s.output.allocate(width, height, GL_RGBA8, false);
    post.output = s.output.framebuffer();
    post.plain = s.quality.plain;
    post.smooth = s.quality.samples == 0 && !s.software;
    constexpr double kWorthIt = 0.5;  // of Quality::render_scale; below it every pixel is a step
    if (s.quality.samples == 0 && s.software && s.quality.render_scale > kWorthIt)
        post.edges = tool_boxes(snapshot, s.tools, s.camera);
    s.post.run(s.picture.texture(), size, post);
    s.times.render_scale = s.quality.render_scale;
    s.times.samples = s.quality.samples;
    s.times.plain = s.quality.plain;
    const double clock_s = s.settings.offscreen ? snapshot.time_s : seconds_of(start);
    s.overlay_painter.draw(s.painter, snapshot, overlay, post.circle, s.camera,
                           {&s.tools, s.depth_cue.feet(), clock_s}, s.times, width, height);
    if (!s.settings.offscreen) {
        glBindFramebuffer(GL_READ_FRAMEBUFFER, post.output);
        glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
        glBlitFramebuffer(0, 0, width, height, 0, 0, width, height, GL_COLOR_BUFFER_BIT,
                          GL_NEAREST);
    }
    const GLenum error = glGetError();
    if (s.error == 0) s.error = error;
    glFinish();  // the time of this picture, not of the queue
    s.adapt(std::chrono::duration<double, std::milli>(Clock::now() - start).count());
    s.context->swap();
    return true;
}

void FetoscopeView::observe(const Snapshot& snapshot) { impl_->observe(snapshot); }
void FetoscopeView::wipe_lens() { impl_->lens.wipe(); }
const Lens& FetoscopeView::lens() const { return impl_->lens; }
bool FetoscopeView::simplify() {
    // Whatever else the processor does is short of time: the caller says when it has some again.
    impl_->stays_simple = true;
    return make_simpler(impl_->quality);
}
bool FetoscopeView::enrich() {
    Quality next = impl_->quality;
    if (!make_richer(next) || !no_richer_than(next, impl_->first_quality)) return false;
    impl_->quality = next;
    return true;
}
bool FetoscopeView::software() const { return impl_->software; }
const std::string& FetoscopeView::renderer() const { return impl_->times.renderer; }
void FetoscopeView::poll(WindowInput& input) { impl_->context->poll(input); }
bool FetoscopeView::close_requested() const { return impl_->context->close_requested(); }
WindowEvents FetoscopeView::events() { return impl_->context->events(); }
std::pair<double, double> FetoscopeView::pointer() const {
    double x = -1, y = -1;
    impl_->context->pointer(x, y);
    return {x, y};
}
void FetoscopeView::capture_pointer(bool capture) { impl_->context->capture_pointer(capture); }
int FetoscopeView::menu_item_under_pointer() const {
    double x = 0, y = 0;
    impl_->context->pointer(x, y);
    return impl_->overlay_painter.menu_item_at(x, y);
}
int FetoscopeView::tuning_item_under_pointer() const {
    double x = 0, y = 0;
    impl_->context->pointer(x, y);
    return impl_->overlay_painter.tuning_item_at(x, y);
}
int FetoscopeView::width() const { return impl_->context->width(); }
int FetoscopeView::height() const { return impl_->context->height(); }
std::pair<int, int> FetoscopeView::window_size() const { return impl_->context->window_size(); }
unsigned FetoscopeView::gl_error() { return std::exchange(impl_->error, 0U); }

std::vector<uint8_t> FetoscopeView::pixels() {
    const int w = width(), h = height();
    impl_->context->make_current();
    const size_t row = static_cast<size_t>(w) * 3;
    std::vector<uint8_t> bottom_up(row * static_cast<size_t>(h)), top_down(bottom_up.size());
    impl_->output.allocate(w, h, GL_RGBA8, false);
    impl_->output.begin();
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, w, h, GL_RGB, GL_UNSIGNED_BYTE, bottom_up.data());
    for (int y = 0; y < h; ++y) {
        std::copy_n(bottom_up.begin() + static_cast<std::ptrdiff_t>(row) * (h - 1 - y), row,
                    top_down.begin() + static_cast<std::ptrdiff_t>(row) * y);
    }
    return top_down;
}

void FetoscopeView::save_png(const std::string& path) {
    write_png(path, width(), height(), pixels());
}

}  // namespace placode::view
