// How a figure gets from a pane into a file: the question where to, the writing, and what is said if it fails.
#pragma once

#include <functional>
#include <optional>

#include <QString>

#include "panes/figure.h"

class QWidget;

namespace reliefui {

class Workspace;

struct FigureFile {
    QString path;
    int pixels = 0;        // the width of a PNG; 0: the standard
    double widthMm = 160;  // on the page; letters and lines have the same size on any
    bool dark = false;     // as in the window; else as in print
    bool caption = true;
};

// Where to, then how; what was chosen is offered again the next time. name: of the view and of the file. vectors: SVG
// and PDF, too. Nothing: it was called off.
std::optional<FigureFile> askFigureFile(QWidget* parent, const QString& title, const QString& name, bool vectors);

// Writes it, on any thread. What is returned says what came of it, on the window's thread: calls `saved`, or says on
// the workspace why not, or that it was cancelled and nothing is written.
std::function<void()> saveFigureFile(const Figure& figure, FigurePage page, const FigureFile& file,
                                     Workspace* workspace, std::function<void()> saved, relief::Work& work);

}  // namespace reliefui
