#include "panes/shader/shader_data.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <stdexcept>

#include "painting/picture_values.h"

namespace reliefui {

namespace {

using relief::Message;
using relief::MessageId;

// Rows that are drawn without a look at whether the user has cancelled.
constexpr int kBand = 32;
// Rays of a pass, for the same reason, and because OpenGL limits the number of groups.
constexpr std::size_t kPassRays = std::size_t{1} << 16;

// A reason that becomes the preview's problem.
[[noreturn]] void refuse(Message why) {
    throw relief::InputError({}, std::move(why));
}

std::unique_ptr<ShaderGl> opened(const ShaderGlSource& open) {
    EglProblem problem{};
    std::unique_ptr<ShaderGl> gl = open(problem);
    if (!gl) refuse(Message(problem == EglProblem::NoEgl ? MessageId::ShaderNoEgl : MessageId::ShaderNoVersion));
    return gl;
}

void checkSide(int width, int height, int most, const std::string& renderer) {
    if (std::max(width, height) <= most) return;
    refuse(Message(MessageId::ShaderTooLarge,
                   {{"width", width}, {"height", height}, {"most", most}, {"renderer", renderer}}));
}

// Before the maps are built, which may take long.
void checkSizes(const ShaderGl& gl, const relief::FrameRequest& request, const std::string& renderer) {
    const ShaderGl::Limits limits = gl.limits();
    int width = request.field.width(), height = request.field.height();
    // The levels lie in a square whose side is a power of two.
    if (request.method.name == "max-pyramid") {
        width = height = static_cast<int>(std::bit_ceil(static_cast<unsigned>(std::max(width, height))));
    }
    checkSide(width, height, request.method.name == "distance" ? limits.volume : limits.texture, renderer);
    if (request.color) checkSide(request.color->width(), request.color->height(), limits.texture, renderer);
    checkSide(request.width, request.height, limits.picture, renderer);
}

void bindAll(ShaderGl& gl, const relief::FrameRequest& request, const relief::ShaderInputs& inputs,
             const relief::ShaderTexture& colors) {
    const relief::Address address = request.field.address();
    for (const auto& [unit, texture] : inputs.textures) gl.setTexture(unit, texture, address);
    gl.setTexture(2, colors, address, request.filter.name == "trilinear");
    gl.setUniforms(inputs.uniforms);
}

// Draws the picture, then again for its time.
void drawPicture(ShaderPreview& out, const relief::ShaderView& view, const std::string& text,
                 const relief::FrameRequest& request, relief::ColorImage& picture, relief::Work& work) {
    ShaderGl::Drawing drawing(view.vertexText, text, request.width, request.height, view.polygons);
    const auto frame = [&] {
        drawing.clear();
        double seconds = 0;
        for (int y = 0; y < request.height; y += kBand) {
            work.throwIfStopped();
            seconds += drawing.draw(y, std::min(y + kBand, request.height));
        }
        return seconds;
    };
    // The first frame also compiles; slow renderers are measured fewer times.
    const double first = frame();
    constexpr double kFast = 0.15, kSlow = 1;
    const int frames = first < kFast ? 9 : first < kSlow ? 3 : 1;
    std::vector<double> times;
    while (static_cast<int>(times.size()) < frames) times.push_back(frame());
    std::ranges::sort(times);
    out.frames = frames;
    out.seconds = times[times.size() / 2];
    out.spread = (times.back() - times.front()) / 2 / out.seconds;
    const std::vector<float> colors = drawing.read().color;
    for (std::size_t i = 0; i < picture.size(); ++i) {
        const float* const c = &colors[4 * i];
        picture.pixels()[i] = c[3] > 0 ? relief::Color(c[0], c[1], c[2]) : request.sky;
    }
}

std::vector<float> tracedRays(ShaderGl& gl, const std::string& text, const relief::RayStage& stage,
                              relief::Work& work) {
    relief::RayBlock rays = stage.rays;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        if (stage.polygon[i] == relief::kNoPolygon) rays.set(i, {});
    }
    const std::vector<float> numbers = relief::shaderRays(rays).numbers;
    std::vector<float> answers;
    answers.reserve(numbers.size());
    const std::string pass = relief::rayPassText(text);
    for (std::size_t first = 0; first < numbers.size(); first += 4 * kPassRays) {
        work.throwIfStopped();
        const std::size_t count = std::min(4 * kPassRays, numbers.size() - first);
        const std::vector<float> part = gl.compute(pass, std::span(numbers).subspan(first, count));
        answers.insert(answers.end(), part.begin(), part.end());
    }
    return answers;
}

std::shared_ptr<const ValueSpread> spreadOf(const relief::FloatImage& values) {
    auto spread = std::make_shared<ValueSpread>();
    for (const float value : values.pixels()) {
        if (std::isfinite(value)) spread->add(value);
    }
    spread->finish();
    return spread;
}

void compare(ShaderPreview& out, const ShaderGlSource& open, relief::Work& work) {
    const Snapshot& shown = *out.snapshot;
    if (shown.request->field.tiles() != nullptr) refuse(Message(MessageId::DrawTiled));
    relief::ShaderRequest alike = relief::shaderRequest(*shown.request);
    const relief::FrameRequest& request = alike.request;
    const relief::ShaderChoice choice = relief::shaderChoice(request);
    const std::string text = relief::shaderText(choice, "Reliefscope");
    constexpr int kStages = 5;
    relief::WholeProgress progress(work.progress(), "shader", kStages);
    const std::unique_ptr<ShaderGl> gl = opened(open);
    out.renderer = gl->renderer();
    checkSizes(*gl, request, out.renderer);
    relief::FrameRenderer renderer(shown.maps, true);
    const std::shared_ptr<const relief::Frame> frame = renderer.render(request, work);
    progress.advance();
    const relief::ShaderView view = relief::shaderView(*frame, request);
    bindAll(*gl, request, relief::shaderInputs(choice, request.field, view.uniforms, *shown.maps, work),
            relief::colorTexture(request));
    gl->setUniforms(view.numbers, 1);
    progress.advance();
    relief::ColorImage picture(request.width, request.height);
    drawPicture(out, view, text, request, picture, work);
    progress.advance();
    const std::vector<float> answers = tracedRays(*gl, text, *frame->rays, work);
    progress.advance();
    const relief::ColorImage cpu = relief::shaderLight(*frame, request, *renderer.tracer(), *shown.maps, work);
    relief::ShaderDifferences found = relief::shaderDifferences(*frame, answers, picture, cpu);
    out.shader = pictureValues(picture);
    out.cpu = pictureValues(cpu);
    out.spreads = {spreadOf(found.colors), spreadOf(found.hits)};
    out.colors = std::make_shared<const relief::FloatImage>(std::move(found.colors));
    out.hits = std::make_shared<const relief::FloatImage>(std::move(found.hits));
    out.found = std::move(found);
    out.notes = std::move(alike.notes);
    const bool exact = renderer.tracer()->guarantee() == relief::Guarantee::Exact;
    if (!exact && request.field.address() == relief::Address::Border) {
        out.notes.push_back(Message(MessageId::ShaderNoteExactShadows));
    }
}

}  // namespace

std::unique_ptr<ShaderGl> openShaderGl(EglProblem& problem) {
    return ShaderGl::open(EglPlace::Screen, problem);
}

std::shared_ptr<const ShaderPreview> shaderPreview(std::shared_ptr<const Snapshot> snapshot, const ShaderGlSource& open,
                                                   relief::Work& work) {
    auto out = std::make_shared<ShaderPreview>();
    out->snapshot = std::move(snapshot);
    const auto fail = [&](Message why) {
        auto problem = std::make_shared<ShaderPreview>();
        problem->snapshot = out->snapshot;
        problem->renderer = out->renderer;
        problem->problem = std::move(why);
        return problem;
    };
    try {
        compare(*out, open, work);
    } catch (const relief::InputError& error) {
        return fail(error.message());
    } catch (const ContextLost&) {
        return fail(Message(MessageId::ShaderLost));
    } catch (const std::runtime_error& error) {
        // The compiler's message has several lines.
        const std::string why = error.what();
        return fail(
            Message(MessageId::ShaderRefused, {{"renderer", out->renderer}, {"why", why.substr(0, why.find('\n'))}}));
    }
    return out;
}

}  // namespace reliefui
