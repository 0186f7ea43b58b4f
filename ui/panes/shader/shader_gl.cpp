#include "panes/shader/shader_gl.h"

#include <GL/glcorearb.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <map>
#include <stdexcept>

namespace reliefui {

using relief::Address;
using relief::ShaderTexture;

namespace {

// Calls a function of OpenGL by its name; its type is that of the header: call<PFNGLENABLEPROC>("glEnable")(...).
template <class Function>
Function call(const char* name) {
    const auto function = reinterpret_cast<Function>(EglContext::function(name));
    if (function == nullptr) throw std::runtime_error(std::string("OpenGL has no ") + name);
    return function;
}

// OpenGL does not fail when the card's memory is full, or when the card was reset: only glGetError() reports it.
void throwOnError(const char* what) {
    const GLenum error = call<PFNGLGETERRORPROC>("glGetError")();
    if (error == GL_CONTEXT_LOST || !EglContext::anyCurrent()) throw ContextLost();
    if (error == GL_NO_ERROR) return;
    throw std::runtime_error(std::string(what) +
                             (error == GL_OUT_OF_MEMORY ? ": out of memory" : ": error " + std::to_string(error)));
}

GLuint compiled(GLenum stage, const std::string& text) {
    const GLuint shader = call<PFNGLCREATESHADERPROC>("glCreateShader")(stage);
    const char* const data = text.c_str();
    call<PFNGLSHADERSOURCEPROC>("glShaderSource")(shader, 1, &data, nullptr);
    call<PFNGLCOMPILESHADERPROC>("glCompileShader")(shader);
    GLint fine = 0;
    call<PFNGLGETSHADERIVPROC>("glGetShaderiv")(shader, GL_COMPILE_STATUS, &fine);
    if (fine == GL_TRUE) return shader;
    throwOnError("shader");
    std::array<char, 4096> log{};
    call<PFNGLGETSHADERINFOLOGPROC>("glGetShaderInfoLog")(shader, log.size(), nullptr, log.data());
    throw std::runtime_error(log.data());
}

GLuint linked(const std::vector<GLuint>& shaders) {
    const GLuint program = call<PFNGLCREATEPROGRAMPROC>("glCreateProgram")();
    for (const GLuint shader : shaders) call<PFNGLATTACHSHADERPROC>("glAttachShader")(program, shader);
    call<PFNGLLINKPROGRAMPROC>("glLinkProgram")(program);
    GLint fine = 0;
    call<PFNGLGETPROGRAMIVPROC>("glGetProgramiv")(program, GL_LINK_STATUS, &fine);
    for (const GLuint shader : shaders) call<PFNGLDELETESHADERPROC>("glDeleteShader")(shader);
    if (fine == GL_TRUE) return program;
    throwOnError("shader");
    std::array<char, 4096> log{};
    call<PFNGLGETPROGRAMINFOLOGPROC>("glGetProgramInfoLog")(program, log.size(), nullptr, log.data());
    throw std::runtime_error(log.data());
}

GLuint buffer(GLenum target, unsigned binding, std::size_t count, const float* numbers) {
    GLuint name = 0;
    call<PFNGLGENBUFFERSPROC>("glGenBuffers")(1, &name);
    call<PFNGLBINDBUFFERBASEPROC>("glBindBufferBase")(target, binding, name);
    call<PFNGLBUFFERDATAPROC>("glBufferData")(target, static_cast<GLsizeiptr>(count * sizeof(float)), numbers,
                                              GL_STATIC_DRAW);
    return name;
}

int limitOf(GLenum name) {
    std::array<GLint, 2> values{};  // that of pictures has two
    call<PFNGLGETINTEGERVPROC>("glGetIntegerv")(name, values.data());
    return values[0];
}

void finish() {
    call<PFNGLFINISHPROC>("glFinish")();
}

}  // namespace

struct ShaderGl::Handles {
    std::map<unsigned, GLuint> textures;
    std::map<unsigned, GLuint> uniforms;   // by their binding
    std::map<std::string, GLuint> passes;  // compute programs by their texts
};

ShaderGl::ShaderGl(std::unique_ptr<EglContext> context)
    : context_(std::move(context)), handles_(std::make_unique<Handles>()) {}

// The context owns everything else.
ShaderGl::~ShaderGl() = default;

std::unique_ptr<ShaderGl> ShaderGl::open(EglPlace place, EglProblem& problem) {
    constexpr int kMajor = 4, kMinor = 5;  // what the shaders are written in
    auto context = EglContext::make(kMajor, kMinor, place, problem);
    if (!context) return nullptr;
    return std::unique_ptr<ShaderGl>(new ShaderGl(std::move(context)));
}

ShaderGl::Limits ShaderGl::limits() const {
    const int picture = std::min(limitOf(GL_MAX_RENDERBUFFER_SIZE), limitOf(GL_MAX_VIEWPORT_DIMS));
    const Limits limits{limitOf(GL_MAX_TEXTURE_SIZE), limitOf(GL_MAX_3D_TEXTURE_SIZE), picture};
    throwOnError("limits");
    return limits;
}

std::string ShaderGl::renderer() const {
    const auto* const name = reinterpret_cast<const char*>(call<PFNGLGETSTRINGPROC>("glGetString")(GL_RENDERER));
    if (name == nullptr) throw ContextLost();
    return name;
}

void ShaderGl::setTexture(unsigned unit, const ShaderTexture& data, Address address, bool mips) {
    GLuint& name = handles_->textures[unit];
    if (name != 0) call<PFNGLDELETETEXTURESPROC>("glDeleteTextures")(1, &name);
    call<PFNGLGENTEXTURESPROC>("glGenTextures")(1, &name);
    const GLenum target = data.layers > 1 ? GL_TEXTURE_3D : GL_TEXTURE_2D;
    call<PFNGLACTIVETEXTUREPROC>("glActiveTexture")(GL_TEXTURE0 + unit);
    // A unit holds one texture of each kind; the one that is not read must not have the same unit.
    call<PFNGLBINDTEXTUREPROC>("glBindTexture")(target, name);
    const GLint inside = data.channels == 1 ? GL_R32F : data.channels == 2 ? GL_RG32F : GL_RGBA32F;
    const GLenum format = data.channels == 1 ? GL_RED : data.channels == 2 ? GL_RG : GL_RGBA;
    for (int l = 0; l < static_cast<int>(data.levels.size()); ++l) {
        const int width = std::max(data.width >> l, 1), height = std::max(data.height >> l, 1);
        const float* const numbers = data.levels[static_cast<std::size_t>(l)].data();
        if (target == GL_TEXTURE_3D) {
            call<PFNGLTEXIMAGE3DPROC>("glTexImage3D")(target, l, inside, width, height, data.layers, 0, format,
                                                      GL_FLOAT, numbers);
        } else {
            call<PFNGLTEXIMAGE2DPROC>("glTexImage2D")(target, l, inside, width, height, 0, format, GL_FLOAT, numbers);
        }
    }
    const GLint wrap = address == Address::Repeat ? GL_REPEAT : GL_CLAMP_TO_EDGE;
    mips = mips || data.levels.size() > 1;
    const GLint smallest =
        data.linear ? (mips ? GL_LINEAR_MIPMAP_LINEAR : GL_LINEAR) : (mips ? GL_NEAREST_MIPMAP_NEAREST : GL_NEAREST);
    const auto set = call<PFNGLTEXPARAMETERIPROC>("glTexParameteri");
    set(target, GL_TEXTURE_WRAP_S, wrap);
    set(target, GL_TEXTURE_WRAP_T, wrap);
    set(target, GL_TEXTURE_WRAP_R, GL_CLAMP_TO_EDGE);
    set(target, GL_TEXTURE_MIN_FILTER, smallest);
    set(target, GL_TEXTURE_MAG_FILTER, data.linear ? GL_LINEAR : GL_NEAREST);
    if (mips && data.levels.size() == 1) {
        call<PFNGLGENERATEMIPMAPPROC>("glGenerateMipmap")(target);
    } else {
        set(target, GL_TEXTURE_MAX_LEVEL, static_cast<GLint>(data.levels.size()) - 1);
    }
    throwOnError("texture");
}

void ShaderGl::setUniforms(const std::vector<float>& numbers, unsigned binding) {
    GLuint& name = handles_->uniforms[binding];
    if (name != 0) call<PFNGLDELETEBUFFERSPROC>("glDeleteBuffers")(1, &name);
    name = buffer(GL_UNIFORM_BUFFER, binding, numbers.size(), numbers.data());
}

std::vector<float> ShaderGl::compute(const std::string& text, std::span<const float> rays) {
    // Compiling takes longer than most passes.
    GLuint& program = handles_->passes[text];
    if (program == 0) program = linked({compiled(GL_COMPUTE_SHADER, text)});
    call<PFNGLUSEPROGRAMPROC>("glUseProgram")(program);
    std::array<GLuint, 2> buffers{buffer(GL_SHADER_STORAGE_BUFFER, 0, rays.size(), rays.data()),
                                  buffer(GL_SHADER_STORAGE_BUFFER, 1, rays.size(), nullptr)};
    constexpr std::size_t kGroup = relief::kRaysPerGroup;
    const auto groups = static_cast<GLuint>((rays.size() / 4 + kGroup - 1) / kGroup);
    call<PFNGLDISPATCHCOMPUTEPROC>("glDispatchCompute")(groups, 1, 1);
    call<PFNGLMEMORYBARRIERPROC>("glMemoryBarrier")(GL_BUFFER_UPDATE_BARRIER_BIT);
    std::vector<float> out(rays.size());
    call<PFNGLBINDBUFFERPROC>("glBindBuffer")(GL_SHADER_STORAGE_BUFFER, buffers[1]);
    call<PFNGLGETBUFFERSUBDATAPROC>("glGetBufferSubData")(
        GL_SHADER_STORAGE_BUFFER, 0, static_cast<GLsizeiptr>(out.size() * sizeof(float)), out.data());
    call<PFNGLDELETEBUFFERSPROC>("glDeleteBuffers")(2, buffers.data());
    throwOnError("rays");
    return out;
}

struct ShaderGl::Drawing::Names {
    GLuint program = 0, frame = 0, vertices = 0;
    std::array<GLuint, 2> targets{};
};

ShaderGl::Drawing::Drawing(const std::string& vertexText, const std::string& fragmentText, int width, int height,
                           int strips)
    : names_(std::make_unique<Names>()), width_(width), height_(height), strips_(strips) {
    names_->program = linked({compiled(GL_VERTEX_SHADER, vertexText), compiled(GL_FRAGMENT_SHADER, fragmentText)});
    call<PFNGLGENFRAMEBUFFERSPROC>("glGenFramebuffers")(1, &names_->frame);
    call<PFNGLBINDFRAMEBUFFERPROC>("glBindFramebuffer")(GL_FRAMEBUFFER, names_->frame);
    call<PFNGLGENRENDERBUFFERSPROC>("glGenRenderbuffers")(2, names_->targets.data());
    for (const std::size_t which : {0U, 1U}) {
        call<PFNGLBINDRENDERBUFFERPROC>("glBindRenderbuffer")(GL_RENDERBUFFER, names_->targets[which]);
        call<PFNGLRENDERBUFFERSTORAGEPROC>("glRenderbufferStorage")(
            GL_RENDERBUFFER, which == 0 ? GL_RGBA32F : GL_DEPTH_COMPONENT32F, width, height);
        call<PFNGLFRAMEBUFFERRENDERBUFFERPROC>("glFramebufferRenderbuffer")(
            GL_FRAMEBUFFER, which == 0 ? GL_COLOR_ATTACHMENT0 : GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER,
            names_->targets[which]);
    }
    call<PFNGLGENVERTEXARRAYSPROC>("glGenVertexArrays")(1, &names_->vertices);
    call<PFNGLBINDVERTEXARRAYPROC>("glBindVertexArray")(names_->vertices);
    call<PFNGLUSEPROGRAMPROC>("glUseProgram")(names_->program);
    call<PFNGLVIEWPORTPROC>("glViewport")(0, 0, width, height);
    call<PFNGLENABLEPROC>("glEnable")(GL_DEPTH_TEST);
    throwOnError("picture");
}

ShaderGl::Drawing::~Drawing() {
    call<PFNGLDELETEFRAMEBUFFERSPROC>("glDeleteFramebuffers")(1, &names_->frame);
    call<PFNGLDELETERENDERBUFFERSPROC>("glDeleteRenderbuffers")(2, names_->targets.data());
    call<PFNGLDELETEVERTEXARRAYSPROC>("glDeleteVertexArrays")(1, &names_->vertices);
    call<PFNGLDELETEPROGRAMPROC>("glDeleteProgram")(names_->program);
}

void ShaderGl::Drawing::clear() {
    call<PFNGLDISABLEPROC>("glDisable")(GL_SCISSOR_TEST);
    call<PFNGLCLEARCOLORPROC>("glClearColor")(0, 0, 0, 0);
    call<PFNGLCLEARPROC>("glClear")(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

double ShaderGl::Drawing::draw(int first, int last) {
    call<PFNGLENABLEPROC>("glEnable")(GL_SCISSOR_TEST);
    call<PFNGLSCISSORPROC>("glScissor")(0, first, width_, last - first);
    finish();
    const auto begin = std::chrono::steady_clock::now();
    call<PFNGLDRAWARRAYSINSTANCEDPROC>("glDrawArraysInstanced")(GL_TRIANGLE_STRIP, 0, 4, strips_);
    finish();
    throwOnError("picture");
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

ShaderGl::Picture ShaderGl::Drawing::read() const {
    const auto pixels = static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_);
    Picture picture{std::vector<float>(4 * pixels), std::vector<float>(pixels)};
    const auto read = call<PFNGLREADPIXELSPROC>("glReadPixels");
    read(0, 0, width_, height_, GL_RGBA, GL_FLOAT, picture.color.data());
    read(0, 0, width_, height_, GL_DEPTH_COMPONENT, GL_FLOAT, picture.depth.data());
    throwOnError("picture");
    return picture;
}

ShaderGl::Picture ShaderGl::draw(const std::string& vertexText, const std::string& fragmentText, int width,
                                 int height) {
    Drawing drawing(vertexText, fragmentText, width, height);
    drawing.clear();
    drawing.draw(0, height);
    return drawing.read();
}

}  // namespace reliefui
