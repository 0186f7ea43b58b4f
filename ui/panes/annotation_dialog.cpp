#include "panes/annotation_dialog.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLineEdit>
#include <QPushButton>

#include "workspace/annotation_state.h"

namespace reliefui {

AnnotationDialog::AnnotationDialog(const Annotation& note, QWidget* parent)
    : QDialog(parent),
      note_(note),
      text_(new QLineEdit(QString::fromStdString(note.text), this)),
      ukrainian_(new QLineEdit(QString::fromStdString(note.ukrainian), this)),
      color_(new QComboBox(this)) {
    setWindowTitle(tr("Annotation"));
    setObjectName(QStringLiteral("annotation-dialog"));
    const int most = note.kind == AnnotationKind::Number ? kMostNumberText : kMostAnnotationText;
    for (QLineEdit* const line : {text_, ukrainian_}) line->setMaxLength(most);
    text_->setObjectName(QStringLiteral("annotation-text"));
    text_->setMinimumWidth(260);
    ukrainian_->setObjectName(QStringLiteral("annotation-ukrainian"));
    ukrainian_->setPlaceholderText(tr("the same text"));
    // In the order of kAnnotationColors.
    color_->addItems(
        {tr("as text"), tr("vermilion"), tr("orange"), tr("green"), tr("blue"), tr("sky blue"), tr("purple")});
    const auto at = std::find(kAnnotationColors.begin(), kAnnotationColors.end(), note.color);
    color_->setCurrentIndex(static_cast<int>(at - kAnnotationColors.begin()));
    color_->setObjectName(QStringLiteral("annotation-color"));

    auto* const buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    accept_ = buttons->button(QDialogButtonBox::Ok);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(text_, &QLineEdit::textChanged, this, &AnnotationDialog::check);
    auto* const form = new QFormLayout(this);
    form->addRow(tr("&Text:"), text_);
    form->addRow(tr("In &Ukrainian:"), ukrainian_);
    form->addRow(tr("&Colour:"), color_);
    form->addRow(buttons);
    check();
}

// Labels and numbers consist of their text alone.
void AnnotationDialog::check() {
    accept_->setEnabled(note_.hasEnd() || !text_->text().trimmed().isEmpty());
}

Annotation AnnotationDialog::annotation() const {
    Annotation note = note_;
    note.text = text_->text().trimmed().toStdString();
    const std::string ukrainian = ukrainian_->text().trimmed().toStdString();
    note.ukrainian = ukrainian == note.text ? std::string() : ukrainian;
    note.color = kAnnotationColors[static_cast<std::size_t>(std::max(0, color_->currentIndex()))];
    return note;
}

}  // namespace reliefui
