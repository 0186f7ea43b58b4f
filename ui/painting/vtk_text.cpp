#include "painting/vtk_text.h"

#include <algorithm>
#include <cmath>

#include <QDirIterator>
#include <QFile>
#include <QStandardPaths>

namespace reliefui {

namespace {

std::string findFont() {
    const QString name = QStringLiteral("DejaVuSans.ttf");
    QStringList folders{QStringLiteral("/usr/share/fonts/truetype/dejavu"), QStringLiteral("/usr/share/fonts/dejavu"),
                        QStringLiteral("/usr/share/fonts/TTF")};
    for (const QString& folder : folders) {
        const QString path = folder + QLatin1Char('/') + name;
        if (QFile::exists(path)) return QFile::encodeName(path).toStdString();
    }
    for (const QString& folder : QStandardPaths::standardLocations(QStandardPaths::FontsLocation)) {
        QDirIterator files(folder, {name}, QDir::Files, QDirIterator::Subdirectories);
        if (files.hasNext()) return QFile::encodeName(files.next()).toStdString();
    }
    return {};
}

}  // namespace

const std::string& fontFile() {
    static const std::string file = findFont();
    return file;
}

void setText(vtkTextProperty* property, Rgba color, double pixels) {
    if (!fontFile().empty()) {
        property->SetFontFamily(VTK_FONT_FILE);
        property->SetFontFile(fontFile().c_str());
    }
    property->SetFontSize(std::max(1, static_cast<int>(std::lround(pixels))));
    property->SetColor(color.r / 255.0, color.g / 255.0, color.b / 255.0);
    property->SetOpacity(color.a / 255.0);
    property->SetBold(0);
    property->SetItalic(0);
    property->SetShadow(0);
    property->SetJustificationToLeft();
    property->SetVerticalJustificationToBottom();
}

vtkSmartPointer<vtkTextProperty> makeText(Rgba color, double pixels) {
    auto property = vtkSmartPointer<vtkTextProperty>::New();
    setText(property, color, pixels);
    return property;
}

}  // namespace reliefui
