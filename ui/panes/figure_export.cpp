#include "panes/figure_export.h"

#include <QFileInfo>
#include <QInputDialog>

#include "panes/figure_view.h"
#include "panes/file_dialogs.h"

namespace reliefui {

namespace {

constexpr int kStandardWidth = 1600;  // pixels
constexpr int kLeastWidth = 160;
constexpr int kMostWidth = 15000;
constexpr double kMmPerInch = 25.4;

}  // namespace

std::optional<FigureFile> askFigureFile(QWidget* parent, const QString& title, const QString& name, bool vectors) {
    const QString ending = vectors ? QStringLiteral(".svg") : QStringLiteral(".png");
    const QString known = vectors ? QStringLiteral(" (*.svg *.pdf *.png)") : QStringLiteral(" (*.png)");
    FigureFile file;
    file.path = askSaveFile(parent, QStringLiteral("figures"), title, name + ending, FigureView::tr("Figures") + known);
    if (file.path.isEmpty()) return std::nullopt;
    if (QFileInfo(file.path).suffix().isEmpty()) file.path += ending;
    if (QFileInfo(file.path).suffix().compare(QLatin1String("png"), Qt::CaseInsensitive) == 0) {
        bool accepted = false;
        file.pixels = QInputDialog::getInt(parent, title, FigureView::tr("Width, pixels:"), kStandardWidth, kLeastWidth,
                                           kMostWidth, 100, &accepted);
        if (!accepted) return std::nullopt;
    }
    return file;
}

QString saveFigureFile(const Figure& figure, FigurePage page, const FigureFile& file) {
    page.style.theme = Theme::Light;
    // So many pixels of the same page: text grows with the picture.
    if (file.pixels > 0) page.dpi = file.pixels / page.widthMm * kMmPerInch;
    try {
        writeFigure(figure, page, file.path.toStdString());
        return {};
    } catch (const relief::InputError& error) {
        return QString::fromStdString(error.text(page.style.language));
    } catch (const std::exception& error) {
        return QString::fromUtf8(error.what());
    }
}

}  // namespace reliefui
