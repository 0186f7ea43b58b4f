// The figures of the papers, redrawn from the program as one set: a JSON file per figure in ui/paper_figures, see
// FORMATS.md, "Figure of a paper". Each is written as SVG, PDF and PNG in both languages, with a caption for LaTeX and
// a JSON file from which the same bytes are written again.
#pragma once

#include <string>
#include <vector>

#include "scenario/json_reader.h"
#include "windows/html_page.h"

namespace reliefui {

inline constexpr int kPaperFigureVersion = 1;

struct PaperFigure {
    // Most figures have one part; others consist of pictures next to each other, (a), (b), ...
    struct Part {
        FigureKind kind;
        std::string layer;  // of the view "result"; empty: the colours
        double widthMm = 84;
        relief::Scenario scenario;
    };
    // Texts in English and Ukrainian.
    using Texts = std::array<std::string, kPageLanguages.size()>;

    std::string name;  // of its file, without the extension
    std::string paper;
    int number = 0;
    int page = 0;         // 0: not known
    std::string printed;  // the paper's own caption
    Texts caption;
    Texts note;  // how the content differs from the printed figure; empty: it does not
    std::vector<Part> parts;
    relief::Json json;  // what was read

    // "[MIP18], fig. 4, p. 114"
    relief::Message place() const;
};

// datasets: folder of the shipped pictures. Throws InputError with file and line.
PaperFigure readPaperFigure(const std::string& file, const std::string& datasets);

// Returns the files that a list of names, separated by commas, selects: "all", a paper ("MIP18"), a figure ("MIP18-4"),
// or a file of one's own. folder: of the shipped figures. Throws InputError for an unknown name.
std::vector<std::string> paperFigureFiles(const std::string& names, const std::string& folder);

// Writes NAME-en.svg, .pdf, .png, .tex, the same in Ukrainian, and NAME.json, into an existing folder; pictures of a
// figure with several parts are NAME-a-en.svg, ... 3-D views are pixels in all formats. version: of the program. Call
// on the thread of a QApplication. Throws what drawing and writing throw.
void writePaperFigure(const PaperFigure& figure, const std::string& folder, const std::string& version,
                      const LanguageSetter& installLanguage, relief::Work& work);

// Writes all-en.tex and all-uk.tex: documents that show these figures.
void writePaperDocuments(const std::vector<PaperFigure>& figures, const std::string& folder);

}  // namespace reliefui
