// Two to four methods on one camera: side by side, divided, one after the other, or only how they differ; below each
// how far it is from a reference and how fast. Everything is rendered and measured on a thread of the pane's own.
#pragma once

#include <memory>
#include <vector>

#include "panes/compare/compare_data.h"
#include "panes/figure_view.h"
#include "panes/picture_view.h"
#include "workspace/latest_job.h"

class QComboBox;
class QDoubleSpinBox;
class QHBoxLayout;
class QLabel;
class QToolButton;

namespace reliefui {

class OptionsForm;

// The pictures, with the grammar of the result. Dividers are dragged.
class ComparePictures : public PictureView {
    Q_OBJECT
  public:
    explicit ComparePictures(Workspace* workspace, QWidget* parent = nullptr);

    // Null: `why` is said instead.
    void show(std::shared_ptr<const ComparedView> view, relief::MessageId why);
    const ComparedView* view() const { return view_.get(); }
    const CompareLayout& layoutNow() const { return layout_; }
    // Of flicker.
    std::size_t shown() const { return shown_; }
    void setShown(std::size_t method);
    // The middle of a pixel in the picture of a method, if it is seen there.
    std::optional<QPointF> pixelIn(std::size_t method, relief::PixelChoice pixel) const;
    // Whose picture is under the point.
    std::optional<std::size_t> methodAt(QPointF widget) const;
    void relayout();

  signals:
    void hovered(const QString& readout);
    void flickerStopped();

  protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    bool event(QEvent* event) override;
    QRectF roomAt(QPointF widget) const override;
    void tellHover(QPointF at) override;

  private:
    relief::Comparison how() const;
    double unit() const { return workspace()->style().pixelsPerPoint(); }
    QRectF onScreen(const Box& points) const;
    std::optional<std::size_t> dividerAt(QPointF widget) const;
    bool moveDivider(QKeyEvent* event);
    bool dragsFit() const { return layout_.dividers.size() == dividers_.size(); }
    QStringList readouts(relief::PixelChoice pixel) const;

    std::shared_ptr<const ComparedView> view_;
    relief::MessageId why_ = relief::MessageId::DrawNoPicture;
    CompareLayout layout_;
    Drawing legend_;
    Box room_;               // of the layout on this widget
    std::size_t lines_ = 0;  // of numbers, when it was drawn last, this way
    relief::CompareMode mode_{};
    std::size_t shown_ = 0;
    std::optional<std::size_t> dragged_;  // divider
    std::size_t held_ = 0;                // by the keyboard
    std::vector<double> dividers_;        // while one is dragged
};

class CompareView : public FigureView {
    Q_OBJECT
  public:
    explicit CompareView(Workspace* workspace, QWidget* parent = nullptr);
    ~CompareView() override;

    ComparePictures* pictures() const { return pictures_; }
    const ComparedView* view() const { return view_.get(); }
    // Nothing is waited for.
    bool settled() const;

  public slots:
    void addMethod();
    void removeMethod();
    // Puts another method at this place, 0 being A.
    void setMethod(std::size_t number, const QString& name);
    // An option of its method, as its description names it ("inner.layers").
    void setOption(std::size_t number, const QString& name, const QString& text, bool live = false);
    // The options of all methods, to be turned.
    void showOptions(bool on);
    // The method becomes A, so that all panes answer for it; A takes its place.
    void swapWithA(std::size_t number);
    void setMode(relief::CompareMode mode);
    void setMeasure(relief::CompareMeasure measure);
    void setReference(relief::CompareReference reference);
    void cancel() override;

  protected:
    void showSnapshot() override;
    bool outdated() const override;
    std::shared_ptr<const Figure> figure() const override;
    void tell(const QPointF& widget) override;
    void addToMenu(QMenu& menu) override;
    void letGo() override;

  private:
    void makeMethodBar();
    void makeModeBar();
    QWidget* makeOptions();
    void refreshOptions();
    void showControls();
    void change(const relief::Comparison& comparison, const QString& what);
    void startView();
    void startRates();
    void tick();

    QHBoxLayout* bar_ = nullptr;  // the row that is being filled
    ComparePictures* pictures_;
    std::vector<QComboBox*> methods_;
    // Of a method: its name over its options.
    struct OptionsOf {
        QWidget* whole = nullptr;
        QLabel* title = nullptr;
        OptionsForm* form = nullptr;
    };
    std::vector<OptionsOf> options_;
    QWidget* optionsArea_ = nullptr;
    QToolButton* showOptions_ = nullptr;
    QToolButton* add_ = nullptr;
    QToolButton* remove_ = nullptr;
    QComboBox* mode_ = nullptr;
    QComboBox* measure_ = nullptr;
    QComboBox* reference_ = nullptr;
    QDoubleSpinBox* rate_ = nullptr;
    QToolButton* play_ = nullptr;
    QPoint menuAt_;

    std::shared_ptr<const Snapshot> snapshot_;
    std::shared_ptr<const ComparedView> view_;
    std::shared_ptr<Comparer> comparer_ = std::make_shared<Comparer>();  // the job's
    bool coarseRunning_ = false;
    QTimer flicker_;
    std::unique_ptr<LatestJob> job_;  // last: ends before the rest
};

}  // namespace reliefui
