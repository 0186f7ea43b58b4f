// A box for the seed of a procedural relief: any whole number of 64 bits, which a QSpinBox cannot hold.
#pragma once

#include <cstdint>
#include <optional>

#include <QAbstractSpinBox>

namespace reliefui {

class SeedBox : public QAbstractSpinBox {
    Q_OBJECT
  public:
    explicit SeedBox(QWidget* parent = nullptr);

    std::uint64_t value() const { return value_; }
    // Emits no signal.
    void setValue(std::uint64_t value);

    void stepBy(int steps) override;
    QValidator::State validate(QString& input, int& position) const override;
    // Room for four digits, or for all that the value has.
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

  signals:
    void edited();  // the user has chosen another value

  protected:
    StepEnabled stepEnabled() const override;

  private:
    std::optional<std::uint64_t> typed() const;
    void take(std::uint64_t value);

    std::uint64_t value_ = 0;
};

}  // namespace reliefui
