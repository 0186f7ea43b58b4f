// Export of a figure from a pane to a file: the dialogs, writing, and error messages.
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
    int pixels = 0;        // width of a PNG; 0: the default
    double widthMm = 160;  // width of the page; text and lines have the same absolute size at any width
    bool dark = false;     // dark theme as in the window; otherwise the light theme for print
    bool caption = true;
};

// Asks for the file name, then for the options; the choices are remembered for the next time. name: name of the view
// and proposed file name. vectors: offer SVG and PDF. Returns std::nullopt if the user cancelled.
std::optional<FigureFile> askFigureFile(QWidget* parent, const QString& title, const QString& name, bool vectors);

// Writes the figure; may be called on any thread. The returned function must be called on the window's thread and
// reports the outcome: it calls `saved`, or sends a message through the workspace if the export failed or was
// cancelled, in which case nothing was written.
std::function<void()> saveFigureFile(const Figure& figure, FigurePage page, const FigureFile& file,
                                     Workspace* workspace, std::function<void()> saved, relief::Work& work);

}  // namespace reliefui
