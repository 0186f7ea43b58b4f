// Pictures for LaTeX (TikZ): a device for QPainter that writes one tikzpicture, for \input into a document. Texts are
// set in the document's own fonts, Greek letters and subscripts as mathematics; colours have names; pictures of pixels
// are files of their own.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <QImage>
#include <QPaintDevice>
#include <QPainter>

namespace reliefui {

class TikzEngine;

class TikzDevice : public QPaintDevice {
  public:
    struct Picture {
        std::string name;  // of its file
        QImage image;
    };

    // size: in units; unitsPerPoint: of 1/72 inch; stem: beginning of the pictures' names.
    TikzDevice(const QSize& size, double unitsPerPoint, std::string stem);
    ~TikzDevice() override;

    // Sets words in a box (in the painter's coordinates), aligned to its left, middle or right, and centred vertically:
    // the document's fonts are wider or narrower than the measured one. formula: see formula_text.h.
    void words(const QPainter& painter, const QRectF& box, Qt::Alignment side, const QString& text, bool formula);
    // Sets a paragraph below the top of the box, broken into lines by LaTeX.
    void paragraph(const QPainter& painter, const QRectF& box, const QString& text);

    // The whole file. name: of the file, for its first lines; title: what it shows.
    std::string file(const std::string& name, const std::string& title) const;
    const std::vector<Picture>& pictures() const;

    QPaintEngine* paintEngine() const override;

  protected:
    int metric(PaintDeviceMetric metric) const override;

  private:
    QSize size_;
    double unitsPerPoint_;
    std::unique_ptr<TikzEngine> engine_;
};

// Paints text as QPainter::drawText(box, flags, text) does; on a TikzDevice as one piece, in the document's fonts.
void paintWords(QPainter& painter, const QRectF& box, int flags, const QString& text);

}  // namespace reliefui
