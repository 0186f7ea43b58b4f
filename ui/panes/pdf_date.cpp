#include "panes/pdf_date.h"

#include <cmath>

#include <QDateTime>

#include "panes/figure.h"
#include "relief/describe.h"

namespace reliefui {

namespace {

constexpr const char* kVariable = "SOURCE_DATE_EPOCH";
constexpr double kLastSecond = 253402300799;  // of the year 9999

// Adds `shift` to the offsets of all objects that begin behind `place`. table: offset of "xref".
void moveObjects(QByteArray& pdf, int table, int place, int shift) {
    constexpr int kEntry = 20;  // bytes, fixed by the format: ten digits, a space, five digits, " n " or " f ", newline
    constexpr int kDigits = 10;
    constexpr int kKind = 17;
    const int heading = pdf.indexOf('\n', table) + 1;
    for (int at = pdf.indexOf('\n', heading) + 1; at > 0 && at + kEntry <= pdf.size(); at += kEntry) {
        bool number = false;
        const int offset = pdf.mid(at, kDigits).toInt(&number);
        if (!number) return;  // the trailer
        if (pdf[at + kKind] == 'n' && offset > place) {
            pdf.replace(at, kDigits, QByteArray::number(offset + shift).rightJustified(kDigits, '0'));
        }
    }
}

}  // namespace

std::optional<std::int64_t> sourceDate() {
    const QByteArray text = qgetenv(kVariable);
    if (text.isEmpty()) return std::nullopt;
    const double seconds = relief::parseNumber(text.toStdString(), kVariable);
    requireRange(kVariable, seconds, 0, kLastSecond);
    if (seconds != std::floor(seconds)) {
        throw relief::InputError(kVariable, relief::Message(relief::MessageId::NumberOutOfRange,
                                                            {{"value", seconds}, {"range", "0, 1, 2, ..."}}));
    }
    return static_cast<std::int64_t>(seconds);
}

QByteArray withSourceDate(QByteArray pdf) {
    const int begin = pdf.indexOf("/CreationDate (");
    const int end = pdf.indexOf('\n', begin) + 1;
    const QByteArray start = "\nstartxref\n";
    const int startAt = pdf.lastIndexOf(start) + start.size();
    if (begin < 0 || end == 0 || startAt < end) return pdf;
    QByteArray date;
    if (const auto seconds = sourceDate()) {
        const QDateTime time = QDateTime::fromSecsSinceEpoch(*seconds, Qt::UTC);
        date = "/CreationDate (D:" + time.toString(QStringLiteral("yyyyMMddHHmmss")).toLatin1() + "Z)\n";
    }
    const int shift = date.size() - (end - begin);
    const int digits = pdf.indexOf('\n', startAt) - startAt;
    const int table = pdf.mid(startAt, digits).trimmed().toInt() + shift;
    pdf.replace(startAt, digits, QByteArray::number(table) + ' ');  // Qt writes a space as well
    pdf.replace(begin, end - begin, date);
    moveObjects(pdf, table, begin, shift);
    return pdf;
}

}  // namespace reliefui
