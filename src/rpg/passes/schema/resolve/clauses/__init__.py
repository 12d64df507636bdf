"""What each verb and each sentence asks for, and how they go together."""
