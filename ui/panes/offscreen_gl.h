// OpenGL without a window: through Qt if there is a display, otherwise through EGL.
#pragma once

#include <memory>

#include "panes/egl_context.h"

namespace reliefui {

// The context is current during the object's lifetime; afterwards the previous one is restored. The constructor throws
// WorkError if OpenGL is not available.
class OffscreenGl {
  public:
    OffscreenGl();
    ~OffscreenGl();
    OffscreenGl(const OffscreenGl&) = delete;
    OffscreenGl& operator=(const OffscreenGl&) = delete;

    void makeCurrent();

  private:
    struct ByQt;
    std::unique_ptr<ByQt> qt_;
    std::unique_ptr<EglContext> egl_;
};

}  // namespace reliefui
