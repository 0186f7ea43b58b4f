// The date in a PDF: equal figures give equal files, whenever they are written.
#pragma once

#include <cstdint>
#include <optional>

#include <QByteArray>

namespace reliefui {

// The environment variable SOURCE_DATE_EPOCH (reproducible-builds.org): seconds since 1970, UTC; std::nullopt if it is
// not set. Throws InputError if it is not a whole number up to the year 9999.
std::optional<std::int64_t> sourceDate();

// Returns the file that QPdfWriter wrote, with the date of SOURCE_DATE_EPOCH instead of the time of writing, or without
// a date if that is not set. Objects behind the date move; the table of their offsets at the file's end is corrected.
// Throws as sourceDate().
QByteArray withSourceDate(QByteArray pdf);

}  // namespace reliefui
