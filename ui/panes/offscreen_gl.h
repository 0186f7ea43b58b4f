// OpenGL without a window: through Qt where there is a display, through EGL where there is none.
#pragma once

#include <memory>

namespace reliefui {

// Current from its making to its end; what was current before is so again then. Throws WorkError where there is none.
class OffscreenGl {
  public:
    OffscreenGl();
    ~OffscreenGl();
    OffscreenGl(const OffscreenGl&) = delete;
    OffscreenGl& operator=(const OffscreenGl&) = delete;

    void makeCurrent();

  private:
    struct ByQt;
    struct ByEgl;
    std::unique_ptr<ByQt> qt_;
    std::unique_ptr<ByEgl> egl_;
};

}  // namespace reliefui
