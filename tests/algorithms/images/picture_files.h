// Writes pictures of any type directly through OpenImageIO, as other programs would, for the readers' tests.
#pragma once

#include <OpenImageIO/imageio.h>

#include <stdexcept>
#include <string>
#include <vector>

namespace relief::testing {

template <class T>
OIIO::TypeDesc typeOf() {
    return OIIO::TypeDesc(OIIO::BaseTypeFromC<T>::value);
}

// numbers: interleaved, as many as `spec` requires. asType: the type in the file, if other than T.
template <class T>
std::string writeRaw(const std::string& path, OIIO::ImageSpec spec, const std::vector<T>& numbers) {
    const auto output = OIIO::ImageOutput::create(path);
    if (!output || !output->open(path, spec) || !output->write_image(typeOf<T>(), numbers.data()) || !output->close())
        throw std::runtime_error(path + ": " + (output ? output->geterror() : OIIO::geterror()));
    return path;
}

template <class T>
std::string writeRaw(const std::string& path, int width, int height, int channels, const std::vector<T>& numbers) {
    return writeRaw(path, OIIO::ImageSpec(width, height, channels, typeOf<T>()), numbers);
}

}  // namespace relief::testing
