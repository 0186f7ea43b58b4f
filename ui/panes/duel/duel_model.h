// Table model of the duel: a row per moment, a column per method, containing the method's step at that moment.
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
    // Returns true if the run takes a step at this moment, false if it waits.
    bool moves(int row, std::size_t run) const;
    QString cell(int row, std::size_t run) const;

    std::shared_ptr<const Duel> duel_;
    Style style_;
};

}  // namespace reliefui
