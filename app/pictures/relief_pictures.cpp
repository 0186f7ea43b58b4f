// The plug-in through which the program `relief` reads and writes pictures: OpenImageIO and the part of the library
// that calls it. All other library functions that it needs are resolved from the program, which loads the plug-in when
// the first picture is opened.
#include "images/picture_library.h"

extern "C" {
extern const relief::PictureLibrary* const relief_pictures;
const relief::PictureLibrary* const relief_pictures = &relief::kOpenImageIo;
}
