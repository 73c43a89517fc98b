// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The model's contacts: which there are, and where they lie in the pattern.
#include <string>

#include "autodiff_sim/cloth_model.h"
#include "autodiff_sim/error.h"
#include "autodiff_sim/terms/self_contact.h"

namespace clothfit {

void ClothModel::EnableSelfContact() {
  const std::string name = std::string(SelfContact::kName) + "." + SelfContact::kParameters[0].name;
  first_contact_parameter_ = FindParameter(parameters_, name);
  if (first_contact_parameter_ < 0)
    throw InputError("self_contact", "no term of the simulation has the parameter " + name);
  contacts_ = std::make_unique<SelfContacts>(mesh_);
}

bool ClothModel::HasContact(const Eigen::VectorXd& parameters) const {
  return contacts_ != nullptr && parameters[first_contact_parameter_ + SelfContact::kStiffness] !=
                                     SelfContact::kParameters[SelfContact::kStiffness].off;
}

double ClothModel::ContactThickness(const Eigen::VectorXd& parameters) const {
  return parameters[first_contact_parameter_ + SelfContact::kThickness];
}

int ClothModel::FollowContacts(const Eigen::VectorXd& x, const Eigen::VectorXd& parameters) {
  const std::vector<ContactPair>& found = contacts_->Find(x, ContactThickness(parameters));
  const TermContext context = {mesh_, topology_, world_, nullptr, &found};
  for (const Part& part : parts_) part.batch->FollowContacts(context);
  found_contacts_ = &found;
  return static_cast<int>(found.size());
}

bool ClothModel::BindContacts() {
  for (const ContactPair& pair : *found_contacts_) {
    for (const int a : pair.nodes) {
      for (const int b : pair.nodes) {
        if (a < b && pattern_.Find(a, b) < 0) return false;
      }
    }
  }
  for (const Part& part : parts_) {
    if (part.batch->info().name == SelfContact::kName) part.batch->Bind(&pattern_);
  }
  return true;
}

void ClothModel::RebuildPattern() {
  std::vector<std::vector<int>> cliques;
  for (const std::array<int, 4>& pair : contacts_->FindNear())
    cliques.emplace_back(pair.begin(), pair.end());
  MakePatternWith(cliques);
}

void ClothModel::ResetPattern() {
  if (contacts_ == nullptr) return;
  contacts_->Forget();
  MakePatternWith({});
}

}  // namespace clothfit
