// Asks for the text of an annotation, in one language or two, and its colour.
#pragma once

#include <QDialog>

#include "painting/annotation.h"

class QComboBox;
class QLineEdit;
class QPushButton;

namespace reliefui {

class AnnotationDialog : public QDialog {
    Q_OBJECT
  public:
    AnnotationDialog(const Annotation& note, QWidget* parent);
    // The annotation as edited.
    Annotation annotation() const;

  private:
    void check();

    Annotation note_;
    QLineEdit* text_;
    QLineEdit* ukrainian_;
    QComboBox* color_;
    QPushButton* accept_;
};

}  // namespace reliefui
