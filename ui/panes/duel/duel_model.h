// The moments of a duel as a table: a row a moment, a column a method, the step that it takes then.
#pragma once

#include <QAbstractTableModel>

#include "panes/duel/duel_data.h"
#include "workspace/workspace.h"

namespace reliefui {

class DuelModel : public QAbstractTableModel {
    Q_OBJECT
  public:
    explicit DuelModel(QObject* parent = nullptr) : QAbstractTableModel(parent) {}

    void show(std::shared_ptr<const Duel> duel, const Style& style);
    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

  private:
    // Whether the run takes its step at this moment, or waits.
    bool moves(int row, std::size_t run) const;
    QString cell(int row, std::size_t run) const;

    std::shared_ptr<const Duel> duel_;
    Style style_;
};

}  // namespace reliefui
