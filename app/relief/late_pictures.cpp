// Loads OpenImageIO when the first picture is opened: loading it with its dependencies takes longer than most commands
// without a picture run (`relief --version`, `relief list`).
#include <dlfcn.h>

#include <cstring>

#include "images/picture_library.h"
#include "installed.h"
#include "relief/errors.h"

namespace relief {

namespace {

const PictureLibrary* loaded() {
    const std::string path = app::pluginPath("relief_pictures.so");
    const auto broken = [&]() -> InputError {
        return InputError(path, Message(MessageId::FileUnreadable, {{"why", dlerror()}}));
    };
    // Functions of OpenImageIO's many dependencies are bound lazily; those of the plug-in itself are bound now, because
    // it is linked with -z now.
    void* const plugin = dlopen(path.c_str(), RTLD_LAZY | RTLD_LOCAL);
    if (plugin == nullptr) throw broken();
    const void* const symbol = dlsym(plugin, "relief_pictures");
    if (symbol == nullptr) throw broken();
    const PictureLibrary* library = nullptr;
    std::memcpy(&library, symbol, sizeof library);
    return library;
}

}  // namespace

const PictureLibrary& pictureLibrary() {
    static const PictureLibrary* const library = loaded();
    return *library;
}

}  // namespace relief
