"""What the programs share: start-up, documents, panels, messages, theme, GL surface and live link."""
