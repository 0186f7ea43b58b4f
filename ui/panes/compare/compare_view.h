// Two to four methods, filters, mappings or maps of heights on one camera: side by side, divided, one after the other,
// or only how they differ; below each how far it is from a reference and how fast. Everything is rendered and measured
// on a thread of the pane's own.
#pragma once

#include <memory>
#include <optional>
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
class RangeButton;

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
    void setShown(std::size_t number);
    // Of the job that makes what is pending; 0: it has just begun.
    void setProgress(double fraction);
    void setStopped();
    // Whether a picture is seen that is not what the scenario wants in its place.
    bool outdated() const;
    bool veiled() const { return pending_.veil; }
    // The middle of a pixel in one of the pictures, if it is seen there.
    std::optional<QPointF> pixelIn(std::size_t number, relief::PixelChoice pixel) const;
    // Which picture is under the point.
    std::optional<std::size_t> pictureAt(QPointF widget) const;
    void relayout();
    // The scale of differences that is on the screen; none: there is none.
    std::optional<RangedValues> errors() const;

  signals:
    void rangeWanted();  // the bar of colours was clicked
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
    // The scenario, with a divider where it is dragged to.
    relief::Scenario wanted() const;
    void sayPending(relief::Message text);
    double unit() const { return workspace()->style().pixelsPerPoint(); }
    QRectF onScreen(const Box& points) const;
    std::optional<std::size_t> dividerAt(QPointF widget) const;
    bool moveDivider(QKeyEvent* event);
    QRectF legendBar() const;  // of its colours, on the widget; empty: there is none
    bool dragsFit() const { return layout_.dividers.size() == dividers_.size(); }
    QStringList readouts(relief::PixelChoice pixel) const;

    std::shared_ptr<const ComparedView> view_;
    relief::MessageId why_ = relief::MessageId::DrawNoPicture;
    CompareLayout layout_;
    Drawing legend_;
    std::optional<RangedValues> errors_;
    Box room_;               // of the layout on this widget
    std::size_t lines_ = 0;  // of numbers, when it was drawn last, this way
    relief::CompareMode mode_{};
    std::size_t shown_ = 0;
    std::optional<std::size_t> dragged_;  // divider
    std::size_t held_ = 0;                // by the keyboard
    std::vector<double> dividers_;        // while one is dragged
    ComparePending pending_;
    QTimer veil_;
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
    void setSubject(relief::CompareSubject subject);
    // The next one that is not there yet.
    void addOther();
    void removeOther();
    // Puts this one at the place, 0 being A. What stands at another place already changes places with it; what A is
    // gets an option of its own, or is refused with a word.
    void setChoice(std::size_t number, const QString& name);
    // An option of it, as its description names it ("inner.layers").
    void setOption(std::size_t number, const QString& name, const QString& text, bool live = false);
    // The options of all of them, to be turned.
    void showOptions(bool on);
    // It becomes A, so that all panes answer for it; A takes its place.
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
    QWidget* makeMethodBar();
    void makeModeBar();
    QWidget* makeOptions();
    void refreshOptions();
    void showControls();
    void change(const relief::Comparison& comparison, const QString& what);
    void startView();
    // What is left to do for the pictures that are shown: colours in the ranges that are chosen, then rates.
    void proceed();
    // Makes another view of the one that is shown.
    void make(std::function<std::shared_ptr<const ComparedView>(relief::Work&)> work);
    void fillChoosers();
    void tick();

    QHBoxLayout* bar_ = nullptr;  // the row that is being filled
    ComparePictures* pictures_;
    std::vector<QComboBox*> choosers_;
    std::optional<relief::CompareSubject> offered_;  // by the choosers
    // Its name over its options.
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
    QComboBox* subject_ = nullptr;
    QComboBox* mode_ = nullptr;
    QComboBox* measure_ = nullptr;
    QComboBox* reference_ = nullptr;
    QDoubleSpinBox* rate_ = nullptr;
    QToolButton* play_ = nullptr;
    RangeButton* range_ = nullptr;
    QPoint menuAt_;

    std::shared_ptr<const Snapshot> snapshot_;
    std::shared_ptr<const ComparedView> view_;
    std::shared_ptr<Comparer> comparer_ = std::make_shared<Comparer>();  // the job's
    bool coarseRunning_ = false;
    QTimer flicker_;
    std::uint64_t run_ = 0;  // of the job that makes pictures, which are shown one by one
    Mailbox parts_{this};
    std::unique_ptr<LatestJob> job_;  // last: ends before the rest
};

}  // namespace reliefui
