// Alone in its source file: where a program defines pictureLibrary() itself, the linker takes neither this object nor
// OpenImageIO.
#include "images/picture_library.h"

namespace relief {

const PictureLibrary& pictureLibrary() {
    return kOpenImageIo;
}

}  // namespace relief
