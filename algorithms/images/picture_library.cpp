// Alone in its source: where a program defines the function, the linker takes neither this nor OpenImageIO.
#include "images/picture_library.h"

namespace relief {

const PictureLibrary& pictureLibrary() {
    return kOpenImageIo;
}

}  // namespace relief
