"""From the words of a request to what it asks for, before anybody looks at the task."""
