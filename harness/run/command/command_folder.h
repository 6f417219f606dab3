// The folder of one execution of a command: its points, its answer, what it prints.
#pragma once

#include "harness/io/temporary_folder.h"

namespace mwt {

/// Its name says which process of which machine has made it.
class CommandFolder : public TemporaryFolder {
 public:
  CommandFolder();
};

/// Removes the folders that processes of this machine left when they were killed, and kills what runs for them. Time:
/// the folder of temporary files is read once.
void remove_abandoned_command_folders();

}  // namespace mwt
