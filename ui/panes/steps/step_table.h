// The steps of the chosen ray as a table, synchronised with the workspace.
#pragma once

#include <QAbstractTableModel>
#include <QWidget>

#include "workspace/workspace.h"

class QSortFilterProxyModel;
class QTableView;

namespace reliefui {

class StepSentence;

// A row per step; reads the snapshot without copying. Numbers are formatted independently of the locale. The columns of
// another program's file that are none of ours follow the others.
class StepModel : public QAbstractTableModel {
    Q_OBJECT
  public:
    enum Column { Number, Level, Texel, Lambda, Height, Value, Decision, After, Columns };

    explicit StepModel(QObject* parent = nullptr) : QAbstractTableModel(parent) {}

    void show(std::shared_ptr<const Snapshot> snapshot, const Style& style);
    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

    // Sort key: the column's first number, or the decision's rank in the list.
    static constexpr int kSortRole = Qt::UserRole;

  private:
    double sortKey(const relief::Step& step, int row, int column) const;
    QString text(const relief::Step& step, int row, int column) const;
    QString text(double value) const;
    // The further column there; null if it is one of ours.
    const relief::FurtherColumn* further(int column) const;

    std::shared_ptr<const Snapshot> snapshot_;
    Style style_;
};

class StepTable : public QWidget {
    Q_OBJECT
  public:
    explicit StepTable(Workspace* workspace, QWidget* parent = nullptr);

    QTableView* table() const { return table_; }
    QString sentence() const;

  public slots:
    void copyRows();    // the selected rows, or all, with tabs between columns
    void exportRows();  // asks for a file; same columns as `relief trace --steps`

  protected:
    void resizeEvent(QResizeEvent* event) override;

  private:
    void refresh();
    void followStep(int step);
    void applyStyle();
    void shareColumns();

    Workspace* workspace_;
    QModelIndex indexOf(int step) const;  // in the order of the view
    int stepOf(const QModelIndex& index) const;

    StepModel* model_;
    QSortFilterProxyModel* sorted_;
    QTableView* table_;
    StepSentence* sentence_;
    bool following_ = false;  // the selection is being changed by the workspace
};

}  // namespace reliefui
