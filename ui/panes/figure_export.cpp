#include "panes/figure_export.h"

#include <algorithm>

#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QSettings>
#include <QSpinBox>

#include "panes/figure_formats.h"
#include "panes/figure_view.h"
#include "panes/file_dialogs.h"

namespace reliefui {

namespace {

constexpr int kStandardWidth = 1600;  // in pixels
constexpr int kLeastWidth = 160;

QString settingOf(const char* option) {
    return QStringLiteral("figures/") + QString::fromLatin1(option);
}

// List of the widths of journals, which sets the width and follows it.
QComboBox* journalWidths(QDialog* dialog, QDoubleSpinBox* width) {
    auto* const list = new QComboBox(dialog);
    list->setObjectName(QStringLiteral("figure-journal"));
    list->addItem(FigureView::tr("Another width"), 0.0);
    list->addItem(FigureView::tr("Column of a journal (84 mm)"), kColumnMm);
    list->addItem(FigureView::tr("Page of a journal (174 mm)"), kJournalPageMm);
    const auto follow = [list, width] { list->setCurrentIndex(std::max(0, list->findData(width->value()))); };
    QObject::connect(width, qOverload<double>(&QDoubleSpinBox::valueChanged), list, follow);
    QObject::connect(list, qOverload<int>(&QComboBox::activated), width, [list, width](int index) {
        if (index > 0) width->setValue(list->itemData(index).toDouble());
    });
    follow();
    return list;
}

// Dialog for the export options. Updates `file`; returns false if the user cancelled.
bool askFigureOptions(QWidget* parent, const QString& title, bool png, FigureFile& file) {
    QSettings settings;
    QDialog dialog(parent);
    dialog.setWindowTitle(title);
    auto* const form = new QFormLayout(&dialog);
    auto* const width = new QDoubleSpinBox(&dialog);
    width->setObjectName(QStringLiteral("figure-width"));
    width->setLocale(QLocale::c());
    width->setDecimals(0);
    width->setRange(kLeastFigureMm, kMostFigureMm);
    width->setValue(settings.value(settingOf("mm"), file.widthMm).toDouble());
    width->setToolTip(FigureView::tr("Width on paper; letters and lines have the same size at any width"));
    form->addRow(FigureView::tr("For:"), journalWidths(&dialog, width));
    form->addRow(FigureView::tr("Width, mm:"), width);
    auto* const pixels = new QSpinBox(&dialog);
    pixels->setObjectName(QStringLiteral("figure-pixels"));
    pixels->setRange(kLeastWidth, kMostRenderedPixels);
    pixels->setSingleStep(100);
    pixels->setValue(settings.value(settingOf("pixels"), kStandardWidth).toInt());
    if (png) form->addRow(FigureView::tr("Width, pixels:"), pixels);
    pixels->setVisible(png);
    auto* const caption = new QCheckBox(FigureView::tr("Caption below the figure"), &dialog);
    caption->setObjectName(QStringLiteral("figure-caption"));
    caption->setChecked(settings.value(settingOf("caption"), true).toBool());
    form->addRow(caption);
    auto* const dark = new QCheckBox(FigureView::tr("Light on dark, as in the window"), &dialog);
    dark->setObjectName(QStringLiteral("figure-dark"));
    dark->setChecked(settings.value(settingOf("dark"), false).toBool());
    form->addRow(dark);
    auto* const buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, &dialog);
    QObject::connect(buttons, &QDialogButtonBox::accepted, &dialog, &QDialog::accept);
    QObject::connect(buttons, &QDialogButtonBox::rejected, &dialog, &QDialog::reject);
    form->addRow(buttons);
    if (dialog.exec() != QDialog::Accepted) return false;
    file.widthMm = width->value();
    file.pixels = png ? pixels->value() : 0;
    file.caption = caption->isChecked();
    file.dark = dark->isChecked();
    settings.setValue(settingOf("mm"), file.widthMm);
    if (png) settings.setValue(settingOf("pixels"), file.pixels);
    settings.setValue(settingOf("caption"), file.caption);
    settings.setValue(settingOf("dark"), file.dark);
    return true;
}

}  // namespace

std::optional<FigureFile> askFigureFile(QWidget* parent, const QString& title, const QString& name, bool vectors) {
    const QString ending = vectors ? QStringLiteral(".svg") : QStringLiteral(".png");
    const QString known =
        vectors ? QStringLiteral(" (*.svg *.pdf *.png *.tikz *.tex *.pgf)") : QStringLiteral(" (*.png)");
    FigureFile file;
    file.path = askSaveFile(parent, QStringLiteral("figures"), title, name + ending, FigureView::tr("Figures") + known);
    if (file.path.isEmpty()) return std::nullopt;
    const bool png = QFileInfo(file.path).suffix().compare(QLatin1String("png"), Qt::CaseInsensitive) == 0;
    return askFigureOptions(parent, title, png, file) ? std::optional(file) : std::nullopt;
}

std::function<void()> saveFigureFile(const Figure& figure, FigurePage page, const FigureFile& file,
                                     Workspace* workspace, std::function<void()> saved, relief::Work& work) {
    if (!file.dark) page.style.theme = Theme::Light;
    page.widthMm = file.widthMm;
    page.caption = file.caption;
    // The same page with this many pixels, so text is scaled with the picture.
    page.widthPixels = file.pixels;
    QString problem;
    try {
        writeFigure(figure, page, file.path.toStdString(), work);
        return saved;
    } catch (const relief::Cancelled&) {
        return [workspace, path = file.path] {
            Q_EMIT workspace->notice(FigureView::tr("Cancelled: %1 was not written.").arg(path));
        };
    } catch (const relief::InputError& error) {
        problem = QString::fromStdString(error.text(page.style.language));
    } catch (const std::exception& error) {
        problem = QString::fromUtf8(error.what());
    }
    return [workspace, problem] { Q_EMIT workspace->problem(problem); };
}

}  // namespace reliefui
