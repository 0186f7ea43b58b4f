// An OpenGL context without a window, made by EGL, for any thread. Uses neither Qt nor VTK.
#pragma once

#include <cstdint>
#include <memory>

namespace reliefui {

// Screen: on the graphics card of the X server that DISPLAY names, if it can be used so; otherwise as Nowhere. Nowhere:
// by Mesa, or by the driver of a graphics card that needs no display.
enum class EglPlace : std::uint8_t { Screen, Nowhere };
// Why there is no context.
enum class EglProblem : std::uint8_t { NoEgl, NoVersion };

class EglContext {
  public:
    // Makes a context of the core profile of this version, or a later one, and makes it current on this thread. Returns
    // null if there is none, with the reason.
    static std::unique_ptr<EglContext> make(int major, int minor, EglPlace place, EglProblem& problem);
    // Ends the context; no context is current on this thread afterwards.
    ~EglContext();
    EglContext(const EglContext&) = delete;
    EglContext& operator=(const EglContext&) = delete;

    bool makeCurrent() const;
    // Returns true if a context is current on this thread; without one, functions of OpenGL do nothing.
    static bool anyCurrent();
    // Returns the address of a function of OpenGL; null if there is none.
    static void* function(const char* name);

  private:
    struct Handles;
    explicit EglContext(std::unique_ptr<Handles> handles);

    std::unique_ptr<Handles> handles_;
};

}  // namespace reliefui
