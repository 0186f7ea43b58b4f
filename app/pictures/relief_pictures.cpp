// The plug-in of the program `relief` that reads and writes pictures: OpenImageIO, and what of the library calls it.
// What else it needs of the library it finds in the program, which loads it when the first picture is opened.
#include "images/picture_library.h"

extern "C" {
extern const relief::PictureLibrary* const relief_pictures;
const relief::PictureLibrary* const relief_pictures = &relief::kOpenImageIo;
}
