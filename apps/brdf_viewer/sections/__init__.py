"""The inspector's sections: widgets with intents (signals) and setters, and no knowledge of a scene."""
