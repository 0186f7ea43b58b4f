// Widths and formats of exported figures: SVG, PDF, PNG, and TikZ (tikz, tex, pgf) for LaTeX.
#pragma once

namespace reliefui {

// Widths of a column and of a page of journals.
inline constexpr double kColumnMm = 84;
inline constexpr double kJournalPageMm = 174;
// Formats of figures with vectors.
inline constexpr const char* kVectorFormats = "svg, pdf, png, tikz, tex, pgf";

}  // namespace reliefui
