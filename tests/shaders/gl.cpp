#include "shaders/gl.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/glcorearb.h>

#include <array>
#include <cstdlib>
#include <map>
#include <stdexcept>

namespace relief::test {

namespace {

// Calls a function of OpenGL by its name; its type is that of the header: call<PFNGLENABLEPROC>("glEnable")(...).
template <class Function>
Function call(const char* name) {
    const auto function = reinterpret_cast<Function>(eglGetProcAddress(name));
    if (function == nullptr) throw std::runtime_error(std::string("OpenGL has no ") + name);
    return function;
}

GLuint compiled(GLenum stage, const std::string& text) {
    const GLuint shader = call<PFNGLCREATESHADERPROC>("glCreateShader")(stage);
    const char* const data = text.c_str();
    call<PFNGLSHADERSOURCEPROC>("glShaderSource")(shader, 1, &data, nullptr);
    call<PFNGLCOMPILESHADERPROC>("glCompileShader")(shader);
    GLint fine = 0;
    call<PFNGLGETSHADERIVPROC>("glGetShaderiv")(shader, GL_COMPILE_STATUS, &fine);
    if (fine == GL_TRUE) return shader;
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

}  // namespace

struct Gl::Handles {
    EGLDisplay display = EGL_NO_DISPLAY;
    EGLContext context = EGL_NO_CONTEXT;
    std::map<unsigned, GLuint> textures;
    GLuint uniforms = 0;
    std::map<std::string, GLuint> passes;  // compute programs by their texts
};

std::unique_ptr<Gl> Gl::open(std::string& why) {
    // The same renderer on every machine.
    setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1);
    std::unique_ptr<Gl> gl(new Gl);
    gl->handles_ = std::make_unique<Handles>();
    Handles& handles = *gl->handles_;
    const auto platform =
        reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(eglGetProcAddress("eglGetPlatformDisplayEXT"));
    if (platform != nullptr) handles.display = platform(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (handles.display == EGL_NO_DISPLAY || eglInitialize(handles.display, nullptr, nullptr) == EGL_FALSE) {
        why = "there is no EGL without a display (packages libegl1, libgl1-mesa-dri)";
        return nullptr;
    }
    eglBindAPI(EGL_OPENGL_API);
    const EGLint version[]{
        EGL_CONTEXT_MAJOR_VERSION,           4,       EGL_CONTEXT_MINOR_VERSION, 5, EGL_CONTEXT_OPENGL_PROFILE_MASK,
        EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
    handles.context = eglCreateContext(handles.display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, version);
    if (handles.context == EGL_NO_CONTEXT ||
        eglMakeCurrent(handles.display, EGL_NO_SURFACE, EGL_NO_SURFACE, handles.context) == EGL_FALSE) {
        why = "there is no OpenGL 4.5";
        return nullptr;
    }
    return gl;
}

Gl::~Gl() {
    if (handles_->display == EGL_NO_DISPLAY) return;
    eglMakeCurrent(handles_->display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    if (handles_->context != EGL_NO_CONTEXT) eglDestroyContext(handles_->display, handles_->context);
    eglTerminate(handles_->display);
}

std::string Gl::renderer() const {
    return reinterpret_cast<const char*>(call<PFNGLGETSTRINGPROC>("glGetString")(GL_RENDERER));
}

void Gl::setTexture(unsigned unit, const TextureData& data, Address address) {
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
    const bool mips = data.levels.size() > 1;
    const GLint smallest =
        data.linear ? (mips ? GL_LINEAR_MIPMAP_LINEAR : GL_LINEAR) : (mips ? GL_NEAREST_MIPMAP_NEAREST : GL_NEAREST);
    const auto set = call<PFNGLTEXPARAMETERIPROC>("glTexParameteri");
    set(target, GL_TEXTURE_WRAP_S, wrap);
    set(target, GL_TEXTURE_WRAP_T, wrap);
    set(target, GL_TEXTURE_WRAP_R, GL_CLAMP_TO_EDGE);
    set(target, GL_TEXTURE_MIN_FILTER, smallest);
    set(target, GL_TEXTURE_MAG_FILTER, data.linear ? GL_LINEAR : GL_NEAREST);
    set(target, GL_TEXTURE_MAX_LEVEL, static_cast<GLint>(data.levels.size()) - 1);
}

void Gl::setUniforms(const std::vector<float>& numbers) {
    if (handles_->uniforms != 0) call<PFNGLDELETEBUFFERSPROC>("glDeleteBuffers")(1, &handles_->uniforms);
    handles_->uniforms = buffer(GL_UNIFORM_BUFFER, 0, numbers.size(), numbers.data());
}

std::vector<float> Gl::compute(const std::string& text, const std::vector<float>& rays) {
    // Compiling takes longer than most passes.
    GLuint& program = handles_->passes[text];
    if (program == 0) program = linked({compiled(GL_COMPUTE_SHADER, text)});
    call<PFNGLUSEPROGRAMPROC>("glUseProgram")(program);
    std::array<GLuint, 2> buffers{buffer(GL_SHADER_STORAGE_BUFFER, 0, rays.size(), rays.data()),
                                  buffer(GL_SHADER_STORAGE_BUFFER, 1, rays.size(), nullptr)};
    constexpr std::size_t kGroup = 64;
    const auto groups = static_cast<GLuint>((rays.size() / 4 + kGroup - 1) / kGroup);
    call<PFNGLDISPATCHCOMPUTEPROC>("glDispatchCompute")(groups, 1, 1);
    call<PFNGLMEMORYBARRIERPROC>("glMemoryBarrier")(GL_BUFFER_UPDATE_BARRIER_BIT);
    std::vector<float> out(rays.size());
    call<PFNGLBINDBUFFERPROC>("glBindBuffer")(GL_SHADER_STORAGE_BUFFER, buffers[1]);
    call<PFNGLGETBUFFERSUBDATAPROC>("glGetBufferSubData")(
        GL_SHADER_STORAGE_BUFFER, 0, static_cast<GLsizeiptr>(out.size() * sizeof(float)), out.data());
    call<PFNGLDELETEBUFFERSPROC>("glDeleteBuffers")(2, buffers.data());
    return out;
}

Gl::Picture Gl::draw(const std::string& vertexText, const std::string& fragmentText, int width, int height) {
    const GLuint program = linked({compiled(GL_VERTEX_SHADER, vertexText), compiled(GL_FRAGMENT_SHADER, fragmentText)});
    call<PFNGLUSEPROGRAMPROC>("glUseProgram")(program);
    GLuint frame = 0, empty = 0;
    std::array<GLuint, 2> targets{};
    call<PFNGLGENFRAMEBUFFERSPROC>("glGenFramebuffers")(1, &frame);
    call<PFNGLBINDFRAMEBUFFERPROC>("glBindFramebuffer")(GL_FRAMEBUFFER, frame);
    call<PFNGLGENRENDERBUFFERSPROC>("glGenRenderbuffers")(2, targets.data());
    for (const int which : {0, 1}) {
        call<PFNGLBINDRENDERBUFFERPROC>("glBindRenderbuffer")(GL_RENDERBUFFER,
                                                              targets[static_cast<std::size_t>(which)]);
        call<PFNGLRENDERBUFFERSTORAGEPROC>("glRenderbufferStorage")(
            GL_RENDERBUFFER, which == 0 ? GL_RGBA32F : GL_DEPTH_COMPONENT32F, width, height);
        call<PFNGLFRAMEBUFFERRENDERBUFFERPROC>("glFramebufferRenderbuffer")(
            GL_FRAMEBUFFER, which == 0 ? GL_COLOR_ATTACHMENT0 : GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER,
            targets[static_cast<std::size_t>(which)]);
    }
    call<PFNGLVIEWPORTPROC>("glViewport")(0, 0, width, height);
    call<PFNGLCLEARCOLORPROC>("glClearColor")(0, 0, 0, 0);
    call<PFNGLCLEARPROC>("glClear")(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    call<PFNGLENABLEPROC>("glEnable")(GL_DEPTH_TEST);
    call<PFNGLGENVERTEXARRAYSPROC>("glGenVertexArrays")(1, &empty);
    call<PFNGLBINDVERTEXARRAYPROC>("glBindVertexArray")(empty);
    call<PFNGLDRAWARRAYSPROC>("glDrawArrays")(GL_TRIANGLE_STRIP, 0, 4);
    const auto pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    Picture picture{std::vector<float>(4 * pixels), std::vector<float>(pixels)};
    const auto read = call<PFNGLREADPIXELSPROC>("glReadPixels");
    read(0, 0, width, height, GL_RGBA, GL_FLOAT, picture.color.data());
    read(0, 0, width, height, GL_DEPTH_COMPONENT, GL_FLOAT, picture.depth.data());
    call<PFNGLDELETEFRAMEBUFFERSPROC>("glDeleteFramebuffers")(1, &frame);
    call<PFNGLDELETERENDERBUFFERSPROC>("glDeleteRenderbuffers")(2, targets.data());
    call<PFNGLDELETEVERTEXARRAYSPROC>("glDeleteVertexArrays")(1, &empty);
    call<PFNGLDELETEPROGRAMPROC>("glDeleteProgram")(program);
    return picture;
}

}  // namespace relief::test
