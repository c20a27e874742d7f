#include "speech/language.hpp"

namespace echoway::speech {
namespace {

std::string number(int n) {
  static constexpr const char* kSmall[] = {"zéro",  "un",     "deux",     "trois",  "quatre", "cinq",
                                           "six",   "sept",   "huit",     "neuf",   "dix",    "onze",
                                           "douze", "treize", "quatorze", "quinze", "seize"};
  static constexpr const char* kTens[] = {"",          "",         "vingt",    "trente",       "quarante",
                                          "cinquante", "soixante", "soixante", "quatre-vingt", "quatre-vingt"};
  if (n < 0 || n > 999) return std::to_string(n);
  if (n <= 16) return kSmall[n];
  if (n < 20) return std::string("dix-").append(kSmall[n - 10]);
  if (n < 100) {
    const int tens = n / 10;
    // Seventy and ninety count on from sixty and eighty: soixante-douze, quatre-vingt-douze.
    const int rest = tens == 7 || tens == 9 ? n % 10 + 10 : n % 10;
    std::string words = kTens[tens];
    if (rest == 0) return tens == 8 ? words.append("s") : words;
    const bool and_one = rest % 10 == 1 && tens < 8;  // vingt et un, soixante et onze; but quatre-vingt-un
    return words.append(and_one ? " et " : "-").append(number(rest));
  }
  std::string words = n < 200 ? "cent" : std::string(kSmall[n / 100]).append(n % 100 == 0 ? " cents" : " cent");
  if (n % 100 != 0) words.append(" ").append(number(n % 100));
  return words;
}

}  // namespace

const LanguageTable& french() noexcept {
  static const LanguageTable table = {
      .tag = "fr",
      .lines = {{
          "Stop.",
          "Obstacle {dir}[, {dist}].",
          "Position incertaine. Arrêtez-vous et tournez lentement.",
          "Tournez lentement {side}.",
          "Faites un pas {dir}.",
          "De nouveau {room}.",
          "Ceinture déconnectée.",
          "Ceinture connectée.",
          "Batterie de la ceinture faible.",
          "Capteur {sensor} masqué.",
          "Mauvaise direction.",
          "Nouvel itinéraire.",
          "Aucun chemin sûr.",
          "{turn}",
          "Serrez {side}.",
          "Tout droit[, {dist}].",
          "Arrivé[ : {what}][, {on}].",
          "Prenez {what} {up}[, niveau {level}].",
          "{room}.",
          "Devant vous : {what}[, {dist}].",
          "{what}[ : {dist}].",
          "Porte {dir}[, {dist}].",
          "Escalier {up} {dir}[, {dist}].[ {stairs}.]",
          "Ascenseur {dir}[, {dist}].",
          "Sortie {dir}[, {dist}].",
          "{what} {dir}[, {dist}].",
          "Passage étroit {dir}[, {dist}].",
          "{room}.",
      }},
      .directions = {{"devant", "devant à gauche", "devant à droite", "à gauche", "à droite", "derrière à gauche",
                      "derrière à droite", "derrière vous"}},
      .turns = {{"Tout droit.", "Tournez un peu à gauche.", "Tournez un peu à droite.", "Tournez à gauche.",
                 "Tournez à droite.", "Tournez franchement à gauche.", "Tournez franchement à droite.",
                 "Faites demi-tour."}},
      .on_side = {{"devant vous", "à votre gauche", "à votre droite", "à votre gauche", "à votre droite",
                   "à votre gauche", "à votre droite", "derrière vous"}},
      .sensors = {{"avant", "avant gauche", "gauche", "arrière gauche", "arrière", "arrière droit", "droit",
                   "avant droit"}},
      .sides = {{"à gauche", "à droite"}},
      .vague = {{"un ou deux pas", "quelques pas", "plusieurs pas", "encore un peu"}},
      .clock = "à {n} heures",
      .clock_one = "à une heure",
      .clock_twelve = "à midi",
      .turn_clock = "Tournez {dir}.",
      .degrees = "{side}, {n} degrés",
      .turn_degrees = "Tournez {side}, {n} degrés.",
      .up = "montant",
      .down = "descendant",
      .foot = {"un pied", "{n} pieds", "un demi-pied", "un pied et demi", "{n} pieds et demi"},
      .metre = {"un mètre", "{n} mètres", "un demi-mètre", "un mètre et demi", "{n} mètres et demi"},
      .step = {"un pas", "{n} pas", "un demi-pas", "un pas et demi", "{n} pas et demi"},
      .stair = {"une marche", "{n} marches", "", "", ""},
      .room = "salle {id}",
      .wall = "le mur",
      .door = "la porte",
      .stairs = "l'escalier",
      .elevator = "l'ascenseur",
      .exit = "la sortie",
      .nowhere = "votre destination",
      .number = number,
      .is_singular = [](int halves) { return halves < 4; },
  };
  return table;
}

}  // namespace echoway::speech
