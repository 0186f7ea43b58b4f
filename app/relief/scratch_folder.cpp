#include "scratch_folder.h"

#include <cerrno>
#include <cstdlib>
#include <cstring>

#include "relief/errors.h"
#include "relief/files.h"

namespace relief::app {

ScratchFolder::ScratchFolder() {
    std::error_code error;
    const std::filesystem::path all = std::filesystem::temp_directory_path(error);
    if (error) throw WorkError("TMPDIR", Message(MessageId::FileUnwritable, {{"why", error.message()}}));
    std::string pattern = (all / "relief-XXXXXX").string();
    if (mkdtemp(pattern.data()) == nullptr) {
        throw WorkError(pattern, Message(MessageId::FileUnwritable, {{"why", std::strerror(errno)}}));
    }
    folder_ = pattern;
}

ScratchFolder::~ScratchFolder() {
    std::error_code none;
    std::filesystem::remove_all(folder_, none);
}

Json ScratchFolder::take(const std::string& path) {
    const std::string text = readTextFile(path);
    std::error_code none;
    std::filesystem::remove(path, none);
    return Json::binary({text.begin(), text.end()});
}

void writeBytes(const std::string& path, const std::vector<std::uint8_t>& bytes) {
    writeTextFile(path, std::string(bytes.begin(), bytes.end()));
}

}  // namespace relief::app
