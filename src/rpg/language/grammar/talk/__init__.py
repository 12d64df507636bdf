"""The words around an instruction: politeness, wishes, questions, asides. None of them asks for anything."""
